#pragma once

namespace kanexpr {

/// The method that a simulation takes its steps by.
enum class integrator {
  /// Adams' multistep formulas of order 1 to 12 (CVODE): the fewest evaluations for smooth motions.
  /// Constraints are met at the end of each step, and the formulas are led back where they drift from them.
  adams,
  /// Backward differentiation of order 1 to 5 with exact derivatives (CVODE): stiff systems.
  bdf,
  /// Dormand & Prince's explicit Runge-Kutta pair of order 5 (ARKODE): many events and inputs that jump, as
  /// each step begins anew.
  explicit_runge_kutta,
  /// Kvaerno's implicit pair of order 5 with exact derivatives (ARKODE): stiff systems with many events.
  implicit_runge_kutta,
  /// The equations of all speeds with their multipliers, as a differential-algebraic system (IDA): no choice
  /// of dependent coordinates and speeds enters, so that a motion may pass where that choice is singular. The
  /// constraints are met within the tolerances. Where they depend on each other, `bdf` takes over.
  differential_algebraic,
};

} // namespace kanexpr
