#pragma once

#include <kanexpr/describe/beams/beam.hpp>
#include <kanexpr/symbolic/numbers/nearby_fraction.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace kanexpr {

namespace describe {

/// Writes the tokens of an expression, or only counts them if it has no storage.
struct token_writer {
  token* to = nullptr;
  int size = 0;

  constexpr void write(const token& t) {
    if (to != nullptr) to[size] = t;
    ++size;
  }
  constexpr void write(token_kind what) { write(with(what)); }
  template <class Expression>
  constexpr void write_all(const Expression& e) {
    for (const token& t : e.tokens) write(t);
  }
  constexpr void write_number(double value) {
    token t{};
    t.number = symbolic::nearby_fraction(value);
    write(t);
  }
};

/// A sum that is written term by term.
class written_sum {
public:
  constexpr explicit written_sum(token_writer& to) : to_(to) {}

  /// Completes a term whose tokens have been written.
  constexpr void add_term() {
    if (!is_empty_) to_.write(token_kind::add);
    is_empty_ = false;
  }
  constexpr void subtract_term() {
    to_.write(is_empty_ ? token_kind::negate : token_kind::subtract);
    is_empty_ = false;
  }
  constexpr bool is_empty() const { return is_empty_; }

private:
  token_writer& to_;
  bool is_empty_ = true;
};

/// Returns a direction with the axes of its frame replaced by those of another frame.
template <class Direction>
constexpr auto in_axes_of(const frame_record* frame, const Direction& given) {
  Direction e = given;
  for (token& t : e.tokens)
    if (t.what == token_kind::basis) t.frame = frame;
  return e;
}

/// A place on a beam: the position and the orientation of the section there, as expressions.
template <class Beam, auto xi>
class place_on_beam {
public:
  static constexpr int shapes = Beam::shapes_count;
  static constexpr auto stored =
      stored_numbers<static_cast<std::size_t>(numeric::beams::section_values::count(shapes))>(
          numeric::beams::values_at(Beam::shapes(), static_cast<double>(xi)));
  static constexpr numeric::beams::section_values values{stored.all, shapes};

  /// The position from the root.
  static constexpr void write_offset(token_writer& to) {
    written_sum sum(to);
    if (write_along(to)) {
      to.write_all(unit_along(Beam::direction_of_axis));
      to.write(token_kind::multiply);
      sum.add_term();
    }
    int bends = 0;
    Beam::each_bending([&]<class Word>(const Word*) {
      const deformation what = bends++ == 0 ? deformation::first_bending : deformation::second_bending;
      if (!write_linear(to, what, [](int k) { return values.value(k); })) return;
      to.write_all(unit_along(Word::across));
      to.write(token_kind::multiply);
      sum.add_term();
    });
    if (sum.is_empty()) {
      to.write_number(0);
      to.write_all(unit_along(Beam::direction_of_axis));
      to.write(token_kind::multiply);
    }
  }

  /// The slope in a direction of bending or the angle about the axis; see mechanics::beam_expressions::angle.
  static constexpr void write_angle(token_writer& to, numeric::beams::deformation what) {
    written_sum sum(to);
    if (numeric::beams::is_bending(what)) {
      if (write_linear(to, what, [](int k) { return values.slope(k); })) {
        divide_by_length(to);
        sum.add_term();
      }
      const auto slopes = [](int k, int l) { return values.slope(k) * values.slope(l); };
      if (write_bilinear(to, what, deformation::extension, slopes)) {
        divide_by_length(to), divide_by_length(to);
        sum.subtract_term();
      }
    } else {
      if (write_linear(to, what, [](int k) { return values.value(k); })) sum.add_term();
      if (write_twist(to)) sum.subtract_term();
    }
    if (sum.is_empty()) to.write_number(0);
  }

private:
  using deformation = numeric::beams::deformation;
  static constexpr bool is_zero(double value) { return value * value <= 0; }

  static constexpr auto amplitudes = []<std::size_t... index>(std::index_sequence<index...>) {
    return std::array<token, sizeof...(index)>{Beam::template q<index>.tokens[0]...};
  }(std::make_index_sequence<static_cast<std::size_t>(shapes)>());
  static constexpr const token& amplitude(int k) { return amplitudes[static_cast<std::size_t>(k)]; }
  static constexpr deformation deforms(int k) {
    return deformations_of_beam<Beam>[static_cast<std::size_t>(k)];
  }

  /// Writes Σ c_k q_k; returns false and writes nothing if it vanishes.
  template <class Number>
  static constexpr bool write_linear(token_writer& to, deformation what, Number c) {
    written_sum sum(to);
    for (int k = 0; k < shapes; ++k) {
      if (deforms(k) != what || is_zero(c(k))) continue;
      to.write_number(c(k));
      to.write(amplitude(k));
      to.write(token_kind::multiply);
      sum.add_term();
    }
    return !sum.is_empty();
  }

  static constexpr void divide_by_length(token_writer& to) {
    to.write_all(operand(Beam::length));
    to.write(token_kind::divide);
  }

  /// Writes c q_k q_l.
  static constexpr void write_product(token_writer& to, double c, int k, int l) {
    to.write_number(c);
    to.write(amplitude(k));
    to.write(token_kind::multiply);
    to.write(amplitude(l));
    to.write(token_kind::multiply);
  }

  /// Writes Σ c_kl q_k q_l over the amplitudes of two deformations; returns false and writes nothing if it
  /// vanishes.
  template <class Number>
  static constexpr bool write_bilinear(token_writer& to, deformation one, deformation other, Number c) {
    written_sum sum(to);
    for (int k = 0; k < shapes; ++k)
      for (int l = 0; l < shapes; ++l) {
        if (deforms(k) != one || deforms(l) != other || is_zero(c(k, l))) continue;
        write_product(to, c(k, l), k, l);
        sum.add_term();
      }
    return !sum.is_empty();
  }

  /// Writes a·(b×c) ∫ v'' w' dx with the directions b and c of bending; returns false and writes nothing if
  /// it vanishes.
  static constexpr bool write_twist(token_writer& to) {
    const auto twist = [](int k, int l) { return values.twist(k, l); };
    if (!write_bilinear(to, deformation::first_bending, deformation::second_bending, twist)) return false;
    if constexpr (Beam::bendings == 2) {
      to.write_all(dot(unit_along(Beam::direction_of_axis), cross(unit_along(Beam::template across<0>()),
                                                                  unit_along(Beam::template across<1>()))));
      to.write(token_kind::multiply);
    }
    divide_by_length(to), divide_by_length(to);
    return true;
  }

  /// Writes ½ Σ G_kl q_k q_l; returns false and writes nothing if it vanishes.
  static constexpr bool write_shortening(token_writer& to) {
    written_sum sum(to);
    for (int k = 0; k < shapes; ++k)
      for (int l = 0; l <= k; ++l) {
        const double g = (k == l ? 0.5 : 1.0) * values.shortening(k, l);
        if (is_zero(g)) continue;
        write_product(to, g, k, l);
        sum.add_term();
      }
    return !sum.is_empty();
  }

  /// Writes the displacement along the axis, x + s − ½ Σ G_kl q_k q_l.
  static constexpr bool write_along(token_writer& to) {
    written_sum sum(to);
    if (!is_zero(values.xi())) {
      to.write_number(values.xi());
      to.write_all(operand(Beam::length));
      to.write(token_kind::multiply);
      sum.add_term();
    }
    if (write_linear(to, deformation::extension, [](int k) { return values.value(k); })) sum.add_term();
    if (write_shortening(to)) {
      divide_by_length(to);
      sum.subtract_term();
    }
    return !sum.is_empty();
  }
};

/// The tokens that a function writes, in static storage.
template <auto write>
inline constexpr auto written_tokens = [] {
  constexpr int size = [] {
    token_writer count;
    write(count);
    return count.size;
  }();
  std::array<token, static_cast<std::size_t>(size)> all{};
  token_writer to{all.data()};
  write(to);
  return all;
}();

template <auto write>
constexpr phrase written_phrase(shape kind) {
  return {kind, written_tokens<write>.data(), static_cast<int>(written_tokens<write>.size())};
}

template <class Section, std::size_t stage>
inline constexpr frame_record bent_frame_of_section = Section::template record_of_turn<stage>();

/// The rotation of a section: first by the slopes, about axes perpendicular to the axis of the beam, then
/// about the axis by the angle of torsion and the twist that bending in two directions causes.
template <class Self, class Beam, auto xi>
struct turns_of_section {
  using place = place_on_beam<Beam, xi>;
  using deformation = numeric::beams::deformation;
  static constexpr std::size_t bends = Beam::bendings;
  static constexpr bool twists = Beam::twists || bends == 2;
  static constexpr std::size_t count = bends + (twists ? 1 : 0);

  static constexpr deformation deformation_of(std::size_t stage) {
    return stage == bends ? deformation::torsion
           : stage == 0   ? deformation::first_bending
                          : deformation::second_bending;
  }

  /// The frame before a rotation.
  template <std::size_t stage>
  static constexpr const frame_record* frame_before() {
    if constexpr (stage == 0)
      return Beam::frame();
    else
      return &bent_frame_of_section<turns_of_section, stage - 1>;
  }

  template <std::size_t stage>
  static constexpr auto axis_of_turn() {
    constexpr auto along = unit_along(Beam::direction_of_axis);
    if constexpr (stage < bends)
      return in_axes_of(frame_before<stage>(), cross(along, unit_along(Beam::template across<stage>())));
    else
      return in_axes_of(frame_before<stage>(), along);
  }

  /// Sets the rotation with the given number in the record of the frame that follows it.
  template <std::size_t stage>
  static constexpr void turn(frame_record& r) {
    constexpr auto write = [](token_writer& to) { place::write_angle(to, deformation_of(stage)); };
    r.parent = frame_before<stage>();
    turn_about(r, written_phrase<write>(shape::scalar), phrase_of<axis_of_turn<stage>(), Self>);
  }

  template <std::size_t stage>
  static constexpr frame_record record_of_turn() {
    frame_record r;
    r.called = r.declared_name =
        stage == 0 ? joint_name<"", Self, "bent">.view() : joint_name<"", Self, "bent_twice">.view();
    turn<stage>(r);
    return r;
  }
};

template <class Beam>
concept beam_without_mistake = requires { requires Beam::is_written(); };

} // namespace describe

/// A place on a beam, as a fraction of its length from 0 at the root to 1 at the tip, with the axes of the
/// section there: `struct Tip : section<Tip, Blade, 1> {};` The root is 0.0, because the integer 0 is also
/// the value of 1/2 in C++. A section is a frame and a point: joints are attached to it, loads act on it, and
/// other beams begin at it.
///
/// The section has moved by the deflections, the extension and the foreshortening. Its axes, those of the
/// beam's frame before the deformation, are rotated by the slope in the first direction of bending, then by
/// the slope in the second one, then about the axis by the angle of torsion and by −∫ v'' w' dx, which a beam
/// that bends in two directions turns without torsion. Each rotation is exact, and the axes are those of the
/// bent beam to the second order in the amplitudes.
template <class Self, class Beam, auto... fraction>
struct section : describe::axes<Self>, describe::place_words, describe::section_words {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.declared_name = type_name<Self>();
    r.on_beam = &describe::body_of<Beam>;
    if constexpr (is_written) {
      using turns = describe::turns_of_section<Self, Beam, fraction...>;
      if constexpr (turns::count > 0) {
        turns::template turn<turns::count - 1>(r);
      } else {
        r.parent = Beam::frame();
        describe::turn_about(r, describe::no_phrase,
                             describe::phrase_of<describe::unit_along(Beam::direction_of_axis), Self>);
      }
    }
    return r;
  }

  static constexpr describe::point_record place() {
    describe::point_record r;
    r.declared_name = type_name<Self>();
    r.on_beam = &describe::body_of<Beam>;
    r.is_off_beam = !is_on_beam;
    r.is_at_whole_zero = (describe::is_whole_zero(fraction) || ...);
    if constexpr (is_written) {
      constexpr auto write = [](describe::token_writer& to) {
        describe::place_on_beam<Beam, fraction...>::write_offset(to);
      };
      r.parent = &describe::point_of<typename Beam::base_point>;
      r.offset = describe::written_phrase<write>(describe::shape::vector);
    }
    return r;
  }

private:
  static constexpr bool is_on_beam = [] {
    if constexpr (sizeof...(fraction) == 1)
      if constexpr ((describe::plain_number<std::remove_cv_t<decltype(fraction)>> && ...))
        return ((fraction >= 0 && fraction <= 1) && ...);
    return false;
  }();
  static constexpr bool is_written = is_on_beam && describe::beam_without_mistake<Beam>;
};

} // namespace kanexpr
