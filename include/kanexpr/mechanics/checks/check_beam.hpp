#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <limits>
#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// Whether two directions are perpendicular. If they contain parameters, their product must vanish as it is
/// written.
constexpr bool are_perpendicular(const components& a, const components& b) {
  const expression product = dot(a, b);
  if (!product.is_constant()) return false;
  const double value = product.owner().number_at(product.node()).value();
  return value < 1e-12 && value > -1e-12;
}

constexpr bool is_not_positive(const expression& e) {
  return e.is_constant() && !(e.owner().number_at(e.node()).value() > 0);
}

/// Whether an expression is a number that has overflowed or underflowed.
constexpr bool is_extreme(const expression& e) {
  if (!e.is_constant()) return false;
  const double value = e.owner().number_at(e.node()).value();
  return !(value >= (std::numeric_limits<double>::min)() && value <= (std::numeric_limits<double>::max)());
}

/// Whether the mass or a stiffness of a beam overflows, although its properties are numbers in range.
constexpr bool has_extreme_numbers(const beam& b) {
  const expression cube = b.length * b.length * b.length;
  if (is_extreme(b.mass_per_length * b.length) || is_extreme(cube)) return true;
  for (const deformation d : b.deformations) {
    const expression length = numeric::beams::is_bending(d) ? cube : b.length;
    if (is_extreme(b.stiffness[static_cast<int>(d)] / length)) return true;
  }
  return false;
}

} // namespace detail

/// Checks the directions and the properties of a beam. The second bending stiffness belongs to the second
/// direction of bending.
constexpr base::sentence check_beam(const beam& b) {
  const std::string_view called = b.called.view();
  for (const components& each : {b.axis, b.across[0], b.across[1]})
    if (!is_fixed(each))
      return base::sentence(
          {"beam ", called, " has an axis or a direction of bending that is not fixed in its frame"});
  if (b.axis.is_zero()) return base::sentence({"beam ", called, " has an axis of zero length"});
  for (const deformation d : b.deformations)
    if (numeric::beams::is_bending(d) && b.across[static_cast<int>(d)].is_zero())
      return base::sentence({"beam ", called, " bends in a direction of zero length"});
  for (const components& each : b.across)
    if (!detail::are_perpendicular(b.axis, each))
      return base::sentence({"beam ", called, " bends in a direction that is not perpendicular to its axis"});
  if (!detail::are_perpendicular(b.across[0], b.across[1]))
    return base::sentence(
        {"beam ", called, " bends in two directions that are not perpendicular to each other"});
  const auto check_property = [&](const expression& e, std::string_view what) {
    if (!is_fixed(e))
      return base::sentence(
          {"the ", what, " of beam ", called, " may vary; it may contain only numbers and parameters"});
    return detail::is_not_positive(e)
               ? base::sentence({"the ", what, " of beam ", called, " is not positive"})
               : base::sentence();
  };
  if (const base::sentence found = check_property(b.length, "length")) return found;
  if (const base::sentence found = check_property(b.mass_per_length, "mass per length")) return found;
  constexpr const char* stiffness_names[]{"bending stiffness", "second bending stiffness",
                                          "torsional stiffness", "axial stiffness"};
  for (const deformation d : b.deformations) {
    const int i = static_cast<int>(d);
    if (const base::sentence found = check_property(b.stiffness[i], stiffness_names[i])) return found;
    if (d != deformation::torsion) continue;
    if (const base::sentence found = check_property(b.polar_inertia, "polar inertia")) return found;
  }
  if (detail::has_extreme_numbers(b))
    return base::sentence({"the numbers of beam ", called,
                           " are too large or too small: its mass or its stiffness is not a finite number "
                           "greater than 0"});
  return {};
}

} // namespace kanexpr::mechanics
