#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/numeric/beams/tables.hpp>

#include <cstddef>
#include <string_view>
#include <type_traits>

/// The shapes of a beam, as functions of the fraction ξ = x/L of its length, for `bending<…>`, `torsion<…>`
/// and `extension<…>`.
namespace kanexpr {

namespace describe {

/// The words inside the words of a beam. A word of shapes has these members:
///
///     count          the number of shapes
///     mistake        the end of a sentence; empty if there is none
///     moves_root     whether its shapes intentionally displace or turn the root
///     add_to<bends>(list)   appends the shapes, those of bending or of a rod
enum class beam_part : unsigned char { shapes, profile, polar_inertia };

using shape_list = base::sequence<numeric::beams::shape>;

/// No body at the tip.
struct bare_tip {
  static constexpr bool is_tip_body = true;
  static constexpr bool is_positive = true;
  static constexpr numeric::beams::tip_load load{};
};

template <numeric::beams::ends how, bool frees_root, int modes, class Tip>
struct natural_modes {
  static constexpr describe::beam_part beam_part = describe::beam_part::shapes;
  static constexpr int count = modes < 0 ? 0 : modes;
  static constexpr bool moves_root = frees_root;
  static constexpr std::string_view mistake = [] {
    if (modes < 1) return std::string_view("has natural modes without their number; write clamped_free<2>");
    if constexpr (requires { Tip::is_tip_body; })
      return std::string_view(Tip::is_positive ? "" : "has a tip_body<...> with a negative ratio");
    else
      return std::string_view("has natural modes with an argument that is not a tip_body<...>");
  }();
  template <bool bends>
  static constexpr void add_to(shape_list& to) {
    using numeric::beams::mode_of_bending, numeric::beams::mode_of_rod;
    numeric::beams::tip_load tip{};
    if constexpr (requires { Tip::load; }) tip = Tip::load;
    for (int n = 1; n <= count; ++n)
      if constexpr (bends)
        to.push(mode_of_bending(how, n, tip));
      else
        to.push(mode_of_rod(how, n, tip));
  }
};

template <auto... numbers>
inline constexpr bool are_plain = ((std::is_arithmetic_v<std::remove_cv_t<decltype(numbers)>> && ...));

/// The numbers of a word.
template <auto... numbers>
constexpr base::sequence<double> list_numbers() {
  base::sequence<double> list;
  if constexpr (are_plain<numbers...>) (list.push(static_cast<double>(numbers)), ...);
  return list;
}

/// Every `step`-th number of a word, beginning with number `first`.
constexpr base::sequence<double> each_nth(const base::sequence<double>& all, int first, int step) {
  base::sequence<double> some;
  for (int i = first; i < all.size(); i += step) some.push(all[i]);
  return some;
}

/// Checks stations with `size` numbers each, of which the first is ξ.
template <int size, auto... numbers>
constexpr std::string_view mistake_of_stations() {
  if (!are_plain<numbers...>) return "has stations that are not numbers";
  const base::sequence<double> all = list_numbers<numbers...>();
  if (all.size() % size != 0 || all.size() < 2 * size)
    return size == 2 ? "has stations with an incomplete or single pair of numbers; write stations<0, value, "
                       "..., 1, value>"
                     : "has stations_with_slopes<...> with an incomplete or single triple of numbers; write "
                       "stations_with_slopes<0, value, slope, ..., 1, value, slope>";
  const base::sequence<double> xi = each_nth(all, 0, size);
  for (int i = 1; i < xi.size(); ++i)
    if (!(xi[i - 1] < xi[i])) return "has stations that are not in increasing order";
  if (xi[0] < 0 || xi[0] > 0 || xi.back() < 1 || xi.back() > 1)
    return "has stations that do not begin at 0 and end at 1, the fractions of the length at root and tip";
  return {};
}

} // namespace describe

/// A rigid body at the tip, whose inertia changes the natural modes: its mass divided by the mass of the
/// uniform beam and, optionally, its moment of inertia about the tip divided by the beam's mass times the
/// square of its length; in torsion, the first ratio is that of the inertias about the axis. The body itself
/// is a separate body of the system, at `section<Tip, Beam, 1>`.
template <auto mass_ratio, auto inertia_ratio = 0.0>
struct tip_body {
  static constexpr bool is_tip_body = true;
  static constexpr bool is_positive = mass_ratio >= 0 && inertia_ratio >= 0;
  static constexpr numeric::beams::tip_load load{static_cast<double>(mass_ratio),
                                                 static_cast<double>(inertia_ratio)};
};

/// The first `modes` natural modes of a uniform beam or rod that is clamped at its root and free at its tip,
/// or carries a `tip_body<…>` there. The deflection at the tip is 1.
template <int modes, class Tip = describe::bare_tip>
struct clamped_free : describe::natural_modes<numeric::beams::ends::clamped_free, false, modes, Tip> {};

/// Modes of a beam that is clamped at both ends. The greatest deflection is 1.
template <int modes>
struct clamped_clamped
    : describe::natural_modes<numeric::beams::ends::clamped_clamped, false, modes, describe::bare_tip> {};

/// Modes of a beam that is clamped at its root and pinned at its tip. The greatest deflection is 1.
template <int modes>
struct clamped_pinned
    : describe::natural_modes<numeric::beams::ends::clamped_pinned, false, modes, describe::bare_tip> {};

/// Modes of a beam that is pinned at both ends, sin nπξ. They turn the root: the frame of the beam follows
/// the chord between its ends.
template <int modes>
struct pinned_pinned
    : describe::natural_modes<numeric::beams::ends::pinned_pinned, true, modes, describe::bare_tip> {};

/// Modes of a beam that is pinned at its root and free at its tip, where the deflection is 1. They turn the
/// root and are orthogonal to the rotation of the frame, ∫ ξ φ dξ = 0.
template <int modes>
struct pinned_free
    : describe::natural_modes<numeric::beams::ends::pinned_free, true, modes, describe::bare_tip> {};

/// Modes of a free beam, without the rigid ones; the deflection at the tip is 1. They displace and turn the
/// root and are orthogonal to the motion of the frame, ∫ φ dξ = ∫ ξ φ dξ = 0 (mean axes).
template <int modes>
struct free_free : describe::natural_modes<numeric::beams::ends::free_free, true, modes, describe::bare_tip> {
};

/// The shape c_0 + c_1 ξ + c_2 ξ² + …: `polynomial<0, 0, 1.5, -0.5>`. It must not displace or turn the root.
/// In `profile<…>`, the factor by which a property varies along the beam.
template <auto... coefficients>
struct polynomial {
  static constexpr describe::beam_part beam_part = describe::beam_part::shapes;
  static constexpr int count = 1;
  static constexpr bool moves_root = false;
  static constexpr std::string_view mistake =
      sizeof...(coefficients) == 0            ? "has a polynomial<> without coefficients"
      : !describe::are_plain<coefficients...> ? "has a polynomial<...> whose coefficients are not numbers"
                                              : "";
  static constexpr std::string_view mistake_of_profile = mistake;
  static constexpr numeric::beams::shape as_profile() {
    return numeric::beams::shape::polynomial(describe::list_numbers<coefficients...>());
  }
  template <bool>
  static constexpr void add_to(describe::shape_list& to) {
    to.push(as_profile());
  }
};

/// Values at stations from ξ = 0 to ξ = 1: `stations<0, 0, 0.5, 0.34, 1, 1>`, each a fraction of the length
/// and a value. As a shape of bending, the cubic spline through the values with slope 0 at the root and
/// without curvature at the tip; as a shape of torsion or extension, and in `profile<…>`, straight lines
/// between the stations.
template <auto... pairs>
struct stations {
  static constexpr describe::beam_part beam_part = describe::beam_part::shapes;
  static constexpr int count = 1;
  static constexpr bool moves_root = false;
  static constexpr std::string_view mistake = describe::mistake_of_stations<2, pairs...>();
  static constexpr numeric::beams::shape as_profile() {
    const base::sequence<double> all = describe::list_numbers<pairs...>();
    return numeric::beams::linear_table(describe::each_nth(all, 0, 2), describe::each_nth(all, 1, 2));
  }
  template <bool bends>
  static constexpr void add_to(describe::shape_list& to) {
    if constexpr (bends)
      to.push(of_bending(true));
    else
      to.push(as_profile());
  }
  static constexpr numeric::beams::shape of_bending(bool clamped) {
    const base::sequence<double> all = describe::list_numbers<pairs...>();
    return numeric::beams::spline(describe::each_nth(all, 0, 2), describe::each_nth(all, 1, 2), clamped);
  }
};

/// Values and slopes dφ/dξ at stations, joined by cubic polynomials as in the elements of a finite-element
/// program: `stations_with_slopes<0, 0, 0, 1, 1, 1.5>`.
template <auto... triples>
struct stations_with_slopes {
  static constexpr describe::beam_part beam_part = describe::beam_part::shapes;
  static constexpr int count = 1;
  static constexpr bool moves_root = false;
  static constexpr std::string_view mistake = describe::mistake_of_stations<3, triples...>();
  template <bool>
  static constexpr void add_to(describe::shape_list& to) {
    const base::sequence<double> all = describe::list_numbers<triples...>();
    to.push(numeric::beams::cubic_table(describe::each_nth(all, 0, 3), describe::each_nth(all, 1, 3),
                                        describe::each_nth(all, 2, 3)));
  }
};

/// A shape that intentionally displaces or turns the root: the deformation is measured from a frame that is
/// not fixed to the root section. `unclamped<polynomial<1, 0, -6, 0, 3>>`. A spline through `stations<…>`
/// then has no curvature at the root.
template <class Shape>
struct unclamped : Shape {
  static constexpr bool moves_root = true;
  template <bool bends>
  static constexpr void add_to(describe::shape_list& to) {
    if constexpr (bends && requires { Shape::of_bending(false); })
      to.push(Shape::of_bending(false));
    else
      Shape::template add_to<bends>(to);
  }
};

} // namespace kanexpr
