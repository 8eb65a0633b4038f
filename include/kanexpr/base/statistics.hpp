#pragma once

namespace kanexpr {

/// Counters of an integration.
struct integration_statistics {
  long steps = 0;
  long rate_evaluations = 0; ///< evaluations of ẋ, or of the residual of the equations
  long jacobian_evaluations = 0;
  long error_test_failures = 0;
  long solver_failures = 0; ///< failures of the iterations within implicit steps
  long projections = 0;     ///< projections onto the constraints
  long events = 0;
};

} // namespace kanexpr
