#pragma once

#include <kanexpr/base/one_way.hpp>

/// What works while a program runs and does not depend on its systems is the engine. Every file that uses it
/// compiles it, or the library kanexpr::engine holds it: then KANEXPR_COMPILED_ENGINE is defined wherever the
/// headers are included, and they declare what the library defines.
#if defined KANEXPR_COMPILED_ENGINE
#define KANEXPR_ENGINE
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENGINE", "1");
#else
#define KANEXPR_ENGINE inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENGINE", "2");
#endif
