#pragma once

#include <kanexpr/simulate/integration.hpp>

namespace kanexpr {

/// Moves a system from a state over a time span: `simulate<System>({{q, 0.1}, {u, 0}}, {{m, 1}, {g, 9.81}},
/// {0, 10})`. What the constraints bind in the state is solved for at the start, from the values given, and
/// held there. The result says what went wrong, and holds all that was reached until then; nothing is
/// thrown.
///
/// Another method is named as in `simulate<System, integrator::bdf>(…)`.
template <class System, integrator by = integrator::adams>
simulation<System> simulate(const given_state<System>& x, const given_parameters<System>& p, time_span span,
                            const simulation_options<System>& options = {}) {
  return simulated::integration<System, by>(p, span, options).run(x);
}

} // namespace kanexpr
