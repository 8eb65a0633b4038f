#pragma once

#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/describe/beams/amplitude_symbols.hpp>
#include <kanexpr/describe/beams/deformations.hpp>
#include <kanexpr/describe/body.hpp>
#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/joints/joint_word.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace kanexpr {

namespace describe {

/// The numbers of a beam in static storage.
template <std::size_t size>
struct stored_numbers {
  double all[size == 0 ? 1 : size]{};
  constexpr explicit stored_numbers(const base::sequence<double>& from) {
    for (std::size_t i = 0; i < size; ++i) all[i] = from[static_cast<int>(i)];
  }
};

/// The frame whose basis vectors a direction contains, if there is exactly one.
template <class Direction>
constexpr const frame_record* frame_of_direction(const Direction& given) {
  const frame_record* found = nullptr;
  if constexpr (requires { given.tokens; })
    for (const token& t : given.tokens) {
      if (t.what != token_kind::basis) continue;
      if (t.frame == nullptr || (found != nullptr && found != t.frame)) return nullptr;
      found = t.frame;
    }
  return found;
}

/// Whether an expression is a vector.
template <class Given>
constexpr bool is_vector() {
  if constexpr (requires { shape_of_operand<Given>; })
    return shape_of_operand<Given> == shape::vector;
  else
    return false;
}

template <class Beam>
inline constexpr auto integrals_of_beam = [] {
  constexpr int size = numeric::beams::modal_integrals::count(Beam::shapes_count);
  return stored_numbers<static_cast<std::size_t>(size)>(numeric::beams::integrate_modes(Beam::shapes()));
}();

template <class Beam>
inline constexpr auto deformations_of_beam = [] {
  std::array<numeric::beams::deformation, static_cast<std::size_t>(Beam::shapes_count) + 1> all{};
  std::size_t next = 0;
  const numeric::beams::beam_shapes shapes = Beam::shapes();
  for (const numeric::beams::beam_shape& s : shapes.all) all[next++] = s.what;
  return all;
}();

/// The values of the shapes at equally spaced sections, for pictures of models that are derived at run time.
template <class Beam>
constexpr base::sequence<double> sections_of_beam(int count) {
  return numeric::beams::values_at_sections(Beam::shapes(), count);
}

/// The direction of bending with the given number among words of a beam.
template <std::size_t index, class Word, class... Rest>
constexpr auto across_among() {
  if constexpr (!is_beam_word<Word, beam_word::bending>)
    return across_among<index, Rest...>();
  else if constexpr (index == 0)
    return Word::across;
  else
    return across_among<index - 1, Rest...>();
}

template <class Beam>
inline constexpr beam_record beam_of = Beam::beam_description();

/// A beam, put together from its words.
template <class Self, class Base, auto along, auto length_given, auto mass_given, class... Words>
struct beam_of_words : body_words, amplitude_symbols<Self, Words...> {
private:
  template <class Visit>
  static constexpr void each_word([[maybe_unused]] Visit visit) {
    (visit(static_cast<const Words*>(nullptr)), ...);
  }
  template <beam_word wanted>
  static constexpr int times = (0 + ... + static_cast<int>(is_beam_word<Words, wanted>));

public:
  static constexpr std::string_view form =
      "beam<Self, Root, axis, length, mass per length, bending<direction, EI, shapes>>";
  static constexpr auto direction_of_axis = along;
  static constexpr auto length = length_given;
  using base_point = Base;

  static constexpr int shapes_count = [] {
    int sum = 0;
    beam_of_words::each_word([&]<class Word>(const Word*) {
      if constexpr (requires { Word::is_bending; }) sum += Word::count;
    });
    return sum;
  }();
  static constexpr std::size_t coordinates_count = static_cast<std::size_t>(shapes_count),
                               speeds_count = coordinates_count;

  static constexpr const frame_record* frame() { return frame_of_direction(along); }

  /// The number of directions of bending, and whether the beam twists.
  static constexpr std::size_t bendings = (0 + ... + std::size_t{is_beam_word<Words, beam_word::bending>});
  static constexpr bool twists = (is_beam_word<Words, beam_word::torsion> || ...);
  template <class Visit>
  static constexpr void each_bending(Visit visit) {
    each_word([&]<class Word>(const Word* word) {
      if constexpr (is_beam_word<Word, beam_word::bending>) visit(word);
    });
  }
  /// The direction of bending with the given number.
  template <std::size_t index>
  static constexpr auto across() {
    return across_among<index, Words...>();
  }
  /// Whether the words contain no mistake.
  static constexpr bool is_written() { return mistake_of_words().empty(); }

  /// The shapes of all deformations, in the order of the words.
  static constexpr numeric::beams::beam_shapes shapes() {
    using numeric::beams::deformation;
    numeric::beams::beam_shapes all;
    int bends = 0;
    each_word([&]<class Word>(const Word*) {
      if constexpr (is_beam_word<Word, beam_word::bending>)
        Word::add_to(all, bends++ == 0 ? deformation::first_bending : deformation::second_bending);
      if constexpr (is_beam_word<Word, beam_word::torsion>) {
        Word::add_to(all, deformation::torsion);
        Word::with_polar_inertia([&]<class Polar>(const Polar*) { all.polar = Polar::factor(); });
      }
      if constexpr (is_beam_word<Word, beam_word::extension>) Word::add_to(all, deformation::extension);
      if constexpr (is_beam_word<Word, beam_word::profile>) all.mass = Word::factor();
    });
    return all;
  }

  static constexpr body_record content() {
    body_record r;
    r.called = type_name<Self>();
    r.declared_name = r.called;
    r.center = &point_of<Base>;
    r.frame = frame();
    if constexpr (is_written())
      r.mass = phrase_of<constant(integrals_of_beam<Self>.all[0]) * (mass_given * length_given), Self>;
    r.beam = &beam_of<Self>;
    return r;
  }

  static constexpr beam_record beam_description() {
    beam_record r;
    r.mistake = mistake_of_words();
    if (!r.mistake.empty()) r.form = needs_form(r.mistake) ? form : std::string_view();
    r.axis = phrase_of<unit_along(along), Self>;
    r.length = phrase_of<length_given, Self>;
    r.mass_per_length = phrase_of<mass_given, Self>;
    beam_of_words::list_symbols(r);
    if (!r.mistake.empty()) return r;
    add_words(r);
    if constexpr (is_written()) {
      r.integrals = {integrals_of_beam<Self>.all, shapes_count};
      r.deformations = deformations_of_beam<Self>.data();
      r.sections = sections_of_beam<Self>;
    }
    return r;
  }

private:
  static constexpr void add_words(beam_record& r) {
    using numeric::beams::deformation;
    int bends = 0;
    const auto stiffness = [&](deformation d) -> phrase& { return r.stiffness[static_cast<int>(d)]; };
    each_word([&]<class Word>(const Word*) {
      if constexpr (is_beam_word<Word, beam_word::bending>) {
        const deformation d = bends == 0 ? deformation::first_bending : deformation::second_bending;
        r.across[bends++] = phrase_of<unit_along(Word::across), Self>;
        stiffness(d) = Word::stiffness_given;
      }
      if constexpr (is_beam_word<Word, beam_word::torsion>) {
        stiffness(deformation::torsion) = Word::stiffness_given;
        Word::with_polar_inertia([&]<class Polar>(const Polar*) { r.polar_inertia = Polar::given; });
      }
      if constexpr (is_beam_word<Word, beam_word::extension>)
        stiffness(deformation::extension) = Word::stiffness_given;
      if constexpr (is_beam_word<Word, beam_word::proportional_damping>)
        r.damping_of_mass = Word::of_mass, r.damping_of_stiffness = Word::of_stiffness;
      if constexpr (is_beam_word<Word, beam_word::modal_damping>) r.damping_ratios = Word::all;
    });
  }

  static constexpr std::string_view no_shapes = "has no shapes", no_axis = "has an axis that is not a vector";
  static constexpr bool needs_form(std::string_view mistake) {
    return mistake == no_shapes || mistake == no_axis;
  }

  static constexpr std::string_view mistake_of_words() {
    if (!is_vector<std::remove_cv_t<decltype(along)>>()) return no_axis;
    if (frame() == nullptr) return "has an axis that is not given in the axes of one frame";
    if (!((word_of_a_beam<Words> || is_joint_word<Words, joint_word::by>) && ...))
      return "has an argument that is not a word of a beam; the words are bending<...>, torsion<...>, "
             "extension<...>, profile<...>, proportional_damping<...>, modal_damping<...> and by<...>";
    for (const std::string_view m : {std::string_view(), mistake_of_part<Words>()...})
      if (!m.empty()) return m;
    if (times<beam_word::bending> > 2)
      return "bends in three directions; a beam bends in one direction or in two perpendicular ones";
    if (times<beam_word::torsion> > 1) return "has torsion<...> twice; write one list of shapes";
    if (times<beam_word::extension> > 1) return "has extension<...> twice; write one list of shapes";
    if (times<beam_word::profile> > 1) return "has two profiles of its mass";
    if (times<beam_word::proportional_damping> + times<beam_word::modal_damping> > 1)
      return "has two kinds of damping; write either proportional_damping<...> or modal_damping<...>";
    if (shapes_count == 0) return no_shapes;
    if (beam_of_words::has_other_count())
      return "has by<...> with too few or too many symbols; write a coordinate for each shape, followed by a "
             "speed for each";
    return mistake_of_values();
  }

  static constexpr std::string_view mistake_of_values() {
    std::string_view found;
    each_word([&]<class Word>(const Word*) {
      if constexpr (is_beam_word<Word, beam_word::bending>)
        if (!is_vector<std::remove_cv_t<decltype(Word::across)>>())
          found = "bends in a direction that is not a vector; write bending<direction, EI, shapes>";
      if constexpr (is_beam_word<Word, beam_word::modal_damping>)
        if (Word::count != 1 && Word::count != shapes_count)
          found = "has modal_damping<...> with neither one ratio nor a ratio for each shape";
    });
    return found;
  }
};

} // namespace describe

/// An Euler-Bernoulli beam, a body that bends, twists and stretches: `struct Blade : beam<Blade, Root, R::x,
/// L, rho, bending<R::y, EI, clamped_free<2>>> {};` It begins at the point `Root` and extends along the axis,
/// a direction fixed in a frame, to which its root section is clamped. Its deformation is a sum of shapes;
/// each amplitude is a coordinate, q1_Blade, with the speed u1_Blade = dq1_Blade/dt, unless `by<…>` names
/// other symbols. List it in `bodies<…>`; the coordinates of beams follow those of the system and its joints.
///
/// Words: `bending`, `torsion`, `extension`, `profile`, `proportional_damping`, `modal_damping`, `by`. The
/// equations are correct to the second order in the amplitudes, with foreshortening, hence with the
/// stiffening of rotating beams and the softening of compressed ones. Rotary inertia of bending and shear
/// deformation are neglected. Kane, Ryan & Banerjee (1987), J. Guidance 10(2).
template <class Self, class Root, auto axis, auto length, auto mass_per_length, class... Words>
struct beam : describe::beam_of_words<Self, Root, axis, length, mass_per_length, Words...> {};

} // namespace kanexpr
