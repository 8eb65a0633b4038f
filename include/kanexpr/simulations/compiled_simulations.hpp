#pragma once

#include <kanexpr/base/one_way.hpp>

/// The parts of simulations and operating points that do not depend on a system are either compiled in every
/// file that uses them, or contained in the library kanexpr::simulate_engine. For the latter,
/// KANEXPR_COMPILED_SIMULATIONS is defined wherever the headers are included.
#if defined KANEXPR_COMPILED_SIMULATIONS
#define KANEXPR_SIMULATIONS
KANEXPR_ONE_WAY("KANEXPR_COMPILED_SIMULATIONS", "1");
#else
#define KANEXPR_SIMULATIONS inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_SIMULATIONS", "2");
#endif
