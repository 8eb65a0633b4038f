#pragma once

#include <kanexpr/simulate/integrator.hpp>
#include <kanexpr/simulate/settings.hpp>
#include <kanexpr/simulate/system_interface.hpp>

namespace kanexpr::simulated {

/// Simulates a system from a state over a time span.
template <integrator by>
run_outcome run(system_interface& moved, const double* from, const time_span& span, const settings& options);

} // namespace kanexpr::simulated
