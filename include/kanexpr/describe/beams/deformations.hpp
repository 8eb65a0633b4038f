#pragma once

#include <kanexpr/describe/beams/shapes.hpp>
#include <kanexpr/describe/operators.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/numeric/beams/integrate_modes.hpp>

#include <string_view>

/// The words of a beam.
namespace kanexpr {

namespace describe {

enum class beam_word : unsigned char {
  bending,
  torsion,
  extension,
  profile,
  proportional_damping,
  modal_damping
};

template <class Word>
concept word_of_a_beam = requires { Word::beam_word; };

template <class Word, beam_word wanted>
concept is_beam_word = requires { requires Word::beam_word == wanted; };

template <class Word, beam_part wanted>
concept is_beam_part = requires { requires Word::beam_part == wanted; };

template <class Word>
constexpr int count_shapes() {
  if constexpr (is_beam_part<Word, beam_part::shapes>)
    return Word::count;
  else
    return 0;
}

/// The first profile among the words, or a constant factor.
template <class... Words>
constexpr numeric::beams::shape profile_among() {
  numeric::beams::shape found = numeric::beams::shape::polynomial({1.0});
  [[maybe_unused]] const auto take = [&]<class Word>(const Word*) {
    if constexpr (is_beam_part<Word, beam_part::profile>)
      if constexpr (requires { Word::factor(); }) found = Word::factor();
  };
  (take(static_cast<const Words*>(nullptr)), ...);
  return found;
}

template <class Word>
constexpr std::string_view mistake_of_part() {
  if constexpr (requires { Word::mistake; })
    return Word::mistake;
  else
    return {};
}

/// The words of a deformation: its shapes and the profile of its stiffness.
template <beam_word is, bool bends, class... Words>
struct deformation_words {
  static constexpr describe::beam_word beam_word = is;
  static constexpr bool is_bending = bends;
  static constexpr int count = (0 + ... + count_shapes<Words>());

  static constexpr void add_to(numeric::beams::beam_shapes& to, numeric::beams::deformation what) {
    shape_list shapes;
    const auto add = [&]<class Word>(const Word*) {
      if constexpr (is_beam_part<Word, beam_part::shapes>) Word::template add_to<bends>(shapes);
    };
    (add(static_cast<const Words*>(nullptr)), ...);
    for (const numeric::beams::shape& s : shapes) to.all.push({what, s});
    to.stiffness[static_cast<int>(what)] = profile_among<Words...>();
  }

  static constexpr std::string_view mistake_among(std::string_view without_shapes, std::string_view foreign) {
    for (const std::string_view m : {std::string_view(), mistake_of_part<Words>()...})
      if (!m.empty()) return m;
    if (!((is_beam_part<Words, beam_part::shapes> || is_beam_part<Words, beam_part::profile> ||
           is_beam_part<Words, beam_part::polar_inertia>) &&
          ...))
      return foreign;
    if ((0 + ... + static_cast<int>(is_beam_part<Words, beam_part::profile>)) > 1)
      return "has a deformation with two profiles";
    if (count == 0) return without_shapes;
    if ((does_not_fit_root<Words>() || ...))
      return bends ? "has a shape of bending that displaces or turns the root; write unclamped<...> if this "
                     "is intended"
                   : "has a shape that displaces the root; write unclamped<...> if this is intended";
    return {};
  }

private:
  template <class Word>
  static constexpr bool does_not_fit_root() {
    if constexpr (is_beam_part<Word, beam_part::shapes>) {
      if (Word::moves_root) return false;
      shape_list shapes;
      Word::template add_to<bends>(shapes);
      for (const numeric::beams::shape& s : shapes)
        if (!numeric::beams::fits_clamped_root(s, bends)) return true;
    }
    return false;
  }
};

} // namespace describe

/// The factor by which a property varies along the beam, a `polynomial<…>` of ξ or `stations<…>`: as a word
/// of the beam, of its mass per length; inside `bending`, `torsion` or `extension`, of the stiffness; inside
/// `polar_inertia`, of that. `profile<polynomial<1, -0.4>>` is a property that tapers to 60 % at the tip.
template <class Function>
struct profile {
  static constexpr describe::beam_word beam_word = describe::beam_word::profile;
  static constexpr describe::beam_part beam_part = describe::beam_part::profile;
  static constexpr std::string_view mistake = [] {
    if constexpr (requires { Function::as_profile(); }) {
      if (!Function::mistake.empty() || numeric::beams::is_factor(Function::as_profile()))
        return Function::mistake;
      return std::string_view("has a profile<...> that is negative at some place, or nowhere positive");
    } else
      return std::string_view("has a profile that is neither a polynomial<...> nor stations<...>");
  }();
  static constexpr numeric::beams::shape factor() {
    if constexpr (requires { Function::as_profile(); })
      return Function::as_profile();
    else
      return numeric::beams::shape::polynomial({1.0});
  }
};

/// Bending in a direction across the axis, with the bending stiffness EI: `bending<R::y, EI,
/// clamped_free<2>>`. A beam bends in one direction or in two perpendicular ones. The amplitudes are lengths.
template <auto direction, auto stiffness, class... Words>
struct bending : describe::deformation_words<describe::beam_word::bending, true, Words...> {
  static constexpr auto across = direction;
  static constexpr const describe::phrase& stiffness_given = describe::phrase_of<stiffness>;
  static constexpr std::string_view mistake =
      bending::mistake_among("has bending<...> without a shape",
                             "has bending<...> with an argument that is neither a shape nor a profile<...>");
};

/// The polar moment of inertia of the mass, per length, about the axis of the beam; only inside `torsion`.
template <auto value, class... Profile>
struct polar_inertia {
  static constexpr describe::beam_part beam_part = describe::beam_part::polar_inertia;
  static constexpr std::string_view mistake = [] {
    for (const std::string_view m : {std::string_view(), describe::mistake_of_part<Profile>()...})
      if (!m.empty()) return m;
    if (sizeof...(Profile) > 1 || !(describe::is_beam_part<Profile, describe::beam_part::profile> && ...))
      return std::string_view(
          "has polar_inertia<...> with an argument other than the inertia per length and one profile<...>");
    return std::string_view();
  }();
  static constexpr const describe::phrase& given = describe::phrase_of<value>;
  static constexpr numeric::beams::shape factor() { return describe::profile_among<Profile...>(); }
};

/// Torsion about the axis, with the torsional stiffness GJ: `torsion<GJ, polar_inertia<J>, clamped_free<1>>`.
/// The amplitudes are angles.
template <auto stiffness, class... Words>
struct torsion : describe::deformation_words<describe::beam_word::torsion, false, Words...> {
  static constexpr const describe::phrase& stiffness_given = describe::phrase_of<stiffness>;
  static constexpr int polar_inertias =
      (0 + ... + static_cast<int>(describe::is_beam_part<Words, describe::beam_part::polar_inertia>));
  static constexpr std::string_view mistake =
      polar_inertias != 1
          ? std::string_view("has torsion<...> without one polar_inertia<...>; write torsion<GJ, "
                             "polar_inertia<J>, shapes>")
          : torsion::mistake_among("has torsion<...> without a shape",
                                   "has torsion<...> with an argument that is neither a shape, a "
                                   "polar_inertia<...> nor a profile<...>");

  /// Calls `take` with the word of the polar inertia.
  template <class Take>
  static constexpr void with_polar_inertia(Take&& take) {
    const auto each = [&]<class Word>(const Word* word) {
      if constexpr (describe::is_beam_part<Word, describe::beam_part::polar_inertia>) take(word);
    };
    (each(static_cast<const Words*>(nullptr)), ...);
  }
};

/// Extension along the axis, with the axial stiffness EA: `extension<EA, clamped_free<1>>`. The amplitudes
/// are lengths.
template <auto stiffness, class... Words>
struct extension : describe::deformation_words<describe::beam_word::extension, false, Words...> {
  static constexpr const describe::phrase& stiffness_given = describe::phrase_of<stiffness>;
  static constexpr std::string_view mistake = extension::mistake_among(
      "has extension<...> without a shape",
      "has extension<...> with an argument that is neither a shape nor a profile<...>");
};

/// Structural damping proportional to mass and stiffness: the damping matrix of the amplitudes is alpha M +
/// beta K, with the mass and stiffness matrices of the beam; alpha in 1/s, beta in s.
template <auto alpha, auto beta>
struct proportional_damping {
  static constexpr describe::beam_word beam_word = describe::beam_word::proportional_damping;
  static constexpr const describe::phrase& of_mass = describe::given_phrases_with_zeros<alpha, beta>[0];
  static constexpr const describe::phrase& of_stiffness = describe::given_phrases_with_zeros<alpha, beta>[1];
};

/// Structural damping given by the damping ratio of each shape, in the order of the shapes, or one for all:
/// shape k is damped by 2 ζ_k √(K_kk M_kk), as if it vibrated alone.
template <auto... ratios>
struct modal_damping {
  static constexpr describe::beam_word beam_word = describe::beam_word::modal_damping;
  static constexpr int count = static_cast<int>(sizeof...(ratios));
  static constexpr describe::listing<describe::phrase> all =
      describe::list_of<describe::phrase, &describe::phrase_of<describe::with_zeros(ratios)>...>::all;
};

} // namespace kanexpr
