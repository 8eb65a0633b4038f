#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/brush_tyre.hpp>
#include <kanexpr/mechanics/loads/linear_tyre.hpp>
#include <kanexpr/mechanics/loads/magic_formula.hpp>
#include <kanexpr/mechanics/loads/magic_formula_coefficients.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

namespace kanexpr::mechanics {

/// The forces of a tyre as a function of its slip; only the part of the given model is used.
struct tyre_law {
  using coefficients = magic_formula_coefficients<symbolic::expression>;

  tyre_model model{};
  linear_tyre linear{};
  brush_tyre brush{};
  base::sequence<coefficients> formula{}; ///< one, or none

  /// Whether the slip is the theoretical one, Pacejka (2012), equation 3.4.
  constexpr bool is_by_rolling_speed() const { return model == tyre_model::brush; }
  constexpr bool needs_load() const { return model != tyre_model::linear; }

  constexpr tyre_effort at(const tyre_slip& s) const {
    switch (model) {
    case tyre_model::linear: return linear.at(s);
    case tyre_model::brush: return brush.at(s);
    case tyre_model::magic_formula: return magic_formula(formula[0], s).effort();
    }
    __builtin_unreachable();
  }

  /// Calls `visit` for each value of the law, with its name and its unit.
  template <class Self, class Visit>
  static constexpr void each_value(Self& self, const Visit& visit) {
    namespace si = units::si;
    if (self.model == tyre_model::magic_formula) return each_coefficient(self.formula[0], visit);
    const auto elastic = [&](auto& law) {
      visit(law.slip_stiffness, "the slip stiffness of ", si::newton);
      visit(law.cornering_stiffness, "the cornering stiffness of ", si::newton);
      visit(law.camber_stiffness, "the camber stiffness of ", si::newton);
      visit(law.trail, "the pneumatic trail of ", si::meter);
    };
    if (self.model == tyre_model::linear) return elastic(self.linear);
    visit(self.brush.friction, "the coefficient of friction of ", units::dimensionless);
    elastic(self.brush);
  }

  /// Calls `not_negative` or `positive` for each value that may not be negative, or must be positive, with
  /// its name. The coefficients of the Magic Formula may have any sign.
  template <class NotNegative, class Positive>
  static constexpr void each_bound(const tyre_law& law, const NotNegative& not_negative,
                                   const Positive& positive) {
    if (law.model == tyre_model::magic_formula) {
      positive(law.formula[0].Fz0, "the nominal load Fz0 of ");
      positive(law.formula[0].R0, "the unloaded radius R0 of ");
      positive(law.formula[0].pressure, "the pressure of ");
      positive(law.formula[0].nominal_pressure, "the nominal pressure of ");
      return;
    }
    const bool is_linear = law.model == tyre_model::linear;
    not_negative(is_linear ? law.linear.slip_stiffness : law.brush.slip_stiffness, "the slip stiffness of ");
    not_negative(is_linear ? law.linear.cornering_stiffness : law.brush.cornering_stiffness,
                 "the cornering stiffness of ");
    if (!is_linear) not_negative(law.brush.friction, "the coefficient of friction of ");
  }

private:
  template <class Coefficients, class Visit>
  static constexpr void each_coefficient(Coefficients& c, const Visit& visit) {
    namespace si = units::si;
    const auto number = [&](auto& each) { visit(each, "a coefficient of ", units::dimensionless); };
    coefficients::each_coefficient(c, [&](auto& load, auto& radius, auto& speed, auto&... others) {
      visit(load, "the nominal load Fz0 of ", si::newton);
      visit(radius, "the unloaded radius R0 of ", si::meter);
      visit(speed, "the reference velocity V0 of ", si::meter / si::second);
      (number(others), ...);
    });
    coefficients::each_factor(c, [&](auto& pressure, auto& nominal, auto&... others) {
      visit(pressure, "the pressure of ", si::newton / units::pow<2>(si::meter));
      visit(nominal, "the nominal pressure of ", si::newton / units::pow<2>(si::meter));
      (number(others), ...);
    });
  }
};

} // namespace kanexpr::mechanics
