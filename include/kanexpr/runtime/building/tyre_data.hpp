#pragma once

#include <kanexpr/mechanics/loads/magic_formula_coefficients.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <optional>

namespace kanexpr::runtime {

/// The properties of a tyre in a builder, with the meaning of the words of `tyre<…>`. One of the functions
/// `linear`, `brush` and `of_formula` sets the law: `auto t = tyre_data::brush(0.9, 4e4); t.load = 3000.0;
/// t.standstill = 0.1;`
struct tyre_data {
  using value = std::optional<number_or_expression>;
  using coefficients = mechanics::magic_formula_coefficients<value>;

  /// A normal force k δ (1 + c δ̇) that closes over the width w.
  struct radial_spring {
    number_or_expression stiffness, damping, width;
  };
  /// Two relaxation lengths and the state variables for the deflections, from `builder::state_variable`.
  struct lag {
    number_or_expression forward_length, lateral_length;
    symbolic::expression forward_deflection, lateral_deflection;
  };

  mechanics::tyre_model model = mechanics::tyre_model::linear;
  value slip_stiffness{}, cornering_stiffness{}, friction{};
  value camber_stiffness{}, trail{};
  coefficients formula{};
  value load{};
  std::optional<radial_spring> radial{};
  value standstill{}, effective_radius{};
  std::optional<lag> relaxation{};

  static tyre_data linear(const number_or_expression& slip_stiffness,
                          const number_or_expression& cornering_stiffness) {
    tyre_data t;
    t.slip_stiffness = slip_stiffness, t.cornering_stiffness = cornering_stiffness;
    return t;
  }
  static tyre_data brush(const number_or_expression& friction, const number_or_expression& stiffness) {
    return brush(friction, stiffness, stiffness);
  }
  static tyre_data brush(const number_or_expression& friction, const number_or_expression& slip_stiffness,
                         const number_or_expression& cornering_stiffness) {
    tyre_data t = linear(slip_stiffness, cornering_stiffness);
    t.model = mechanics::tyre_model::brush, t.friction = friction;
    return t;
  }
  static tyre_data of_formula(const coefficients& c) {
    tyre_data t;
    t.model = mechanics::tyre_model::magic_formula, t.formula = c;
    return t;
  }
};

/// The load and the forces of a tyre in a builder, in N, its aligning moment, in N m, and its slips, with the
/// signs of the words of the same names, such as `lateral_force_of<Tyre>`.
struct tyre_forces {
  symbolic::expression load{}, longitudinal_force{}, lateral_force{}, aligning_moment{};
  symbolic::expression longitudinal_slip{}, lateral_slip{}, sine_of_camber{};
};

} // namespace kanexpr::runtime
