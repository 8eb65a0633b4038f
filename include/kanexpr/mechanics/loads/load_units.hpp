#pragma once

#include <kanexpr/mechanics/loads/load_names.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <initializer_list>
#include <string_view>

namespace kanexpr::mechanics {

/// The context in which a load states the units of its expressions.
class load_units : public load_names {
public:
  constexpr load_units(const mechanism& m, unit_inference& by) : load_names(m), by_(by) {}

  /// Names what the next expressions describe: {"the force ", "at P"}.
  constexpr void describe(std::initializer_list<std::string_view> subject) { by_.describe(subject); }
  /// States the unit of a scalar or a vector.
  template <class Quantity>
  constexpr void expect(const Quantity& quantity, const units::unit& u) {
    by_.expect(quantity, u);
  }
  /// States that the two sides of an equation, of which the difference is given, have the same unit.
  constexpr void expect_equation(expression difference) { by_.expect_equation(difference); }
  /// States a unit that does not conflict with others: an expression of a flexible body may contain numbers
  /// with units.
  constexpr void suggest(expression e, const units::unit& u) { by_.suggest(e, u); }
  constexpr void suggest_coefficient(expression e, expression rate, const units::unit& u) {
    by_.suggest_coefficient(e, rate, u);
  }
  /// Reports a sum of different units in an expression of the part described last.
  constexpr void examine(expression e) { by_.examine(e); }
  /// The unit of an expression of the part described last; none if it is not determined.
  constexpr units::possible_unit unit_of(expression e) {
    by_.examine(e);
    return by_.unit_of(e);
  }
  /// Whether the unit of an expression of the part described last is known to be the radian.
  constexpr bool is_angle(expression e) { return unit_of(e) == units::si::radian; }

private:
  unit_inference& by_;
};

} // namespace kanexpr::mechanics
