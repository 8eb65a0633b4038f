#pragma once

#include <kanexpr/base/one_way.hpp>

/// What of ensembles does not depend on a system is compiled by every file that uses it, or the library
/// kanexpr::ensemble_engine holds it: then KANEXPR_COMPILED_ENSEMBLES is defined wherever the headers are
/// included.
#if defined KANEXPR_COMPILED_ENSEMBLES
#define KANEXPR_ENSEMBLES
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENSEMBLES", "1");
#else
#define KANEXPR_ENSEMBLES inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENSEMBLES", "2");
#endif
