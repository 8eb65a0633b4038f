#pragma once

#include <kanexpr/base/one_way.hpp>

/// The code of ensembles that does not depend on a system is compiled in every file that uses it, or only
/// once, in the library kanexpr::ensemble_engine, which defines KANEXPR_COMPILED_ENSEMBLES for all its users.
#if defined KANEXPR_COMPILED_ENSEMBLES
#define KANEXPR_ENSEMBLES
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENSEMBLES", "1");
#else
#define KANEXPR_ENSEMBLES inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENSEMBLES", "2");
#endif
