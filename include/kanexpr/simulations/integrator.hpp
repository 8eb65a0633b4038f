#pragma once

namespace kanexpr {

/// The integration method of a simulation.
enum class integrator {
  /// Adams' multistep formulas of order 1 to 12 (CVODE): the fewest evaluations for smooth motions. The state
  /// is projected onto the constraints after each step, and the drift of the formulas is corrected.
  adams,
  /// Backward differentiation of order 1 to 5 with exact derivatives (CVODE): stiff systems.
  bdf,
  /// Dormand & Prince's explicit Runge-Kutta pair of order 5 (ARKODE): many events and inputs that jump,
  /// since each step starts afresh.
  explicit_runge_kutta,
  /// Kvaerno's implicit pair of order 5 with exact derivatives (ARKODE): stiff systems with many events.
  implicit_runge_kutta,
  /// The equations of all speeds with their multipliers, as a differential-algebraic system (IDA). No choice
  /// of dependent coordinates and speeds is involved, so a motion may pass positions where that choice is
  /// singular. The constraints are satisfied within the tolerances. Where they depend on each other, `bdf`
  /// takes over.
  differential_algebraic,
};

} // namespace kanexpr
