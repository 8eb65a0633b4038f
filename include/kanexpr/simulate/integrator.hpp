#pragma once

#include <kanexpr/compiled/state.hpp>

namespace kanexpr {

/// The method that a simulation takes its steps by.
enum class integrator {
  /// Adams' multistep formulas of order 1 to 12 (CVODE): smooth motions, evaluations that are dear.
  adams,
  /// Backward differentiation of order 1 to 5 with exact derivatives (CVODE): stiff systems.
  bdf,
  /// Dormand & Prince's explicit Runge-Kutta pair of order 5 (ARKODE): constraints and many events, as each
  /// step begins anew.
  explicit_runge_kutta,
  /// Kvaerno's implicit pair of order 5 with exact derivatives (ARKODE): stiff systems with many events.
  implicit_runge_kutta,
  /// The equations of all speeds with their multipliers, as a differential-algebraic system (IDA): no choice
  /// of dependent coordinates and speeds enters, so that a motion may pass where that choice is singular.
  differential_algebraic,
};

/// Where the model has constraints each step must end on them, which costs one-step methods nothing.
template <class System>
inline constexpr integrator natural_integrator =
    compiled::survey_of<System>.constraints + compiled::survey_of<System>.configuration_constraints > 0
        ? integrator::explicit_runge_kutta
        : integrator::adams;

} // namespace kanexpr
