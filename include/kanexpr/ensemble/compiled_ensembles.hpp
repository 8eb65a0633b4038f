#pragma once

/// What of ensembles does not depend on a system is compiled by every file that uses it, or the library
/// kanexpr::ensemble_engine holds it: then KANEXPR_COMPILED_ENSEMBLES is defined wherever the headers are
/// included.
#if defined KANEXPR_COMPILED_ENSEMBLES
#define KANEXPR_ENSEMBLES
#else
#define KANEXPR_ENSEMBLES inline
#endif
