#pragma once

#include <kanexpr/base/one_way.hpp>

/// What of simulations and operating points does not depend on a system is compiled by every file that uses
/// it, or the library kanexpr::simulate_engine holds it: then KANEXPR_COMPILED_SIMULATIONS is defined
/// wherever the headers are included.
#if defined KANEXPR_COMPILED_SIMULATIONS
#define KANEXPR_SIMULATIONS
KANEXPR_ONE_WAY("KANEXPR_COMPILED_SIMULATIONS", "1");
#else
#define KANEXPR_SIMULATIONS inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_SIMULATIONS", "2");
#endif
