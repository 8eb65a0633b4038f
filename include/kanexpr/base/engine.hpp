#pragma once

#include <kanexpr/base/one_way.hpp>

/// The engine is the run-time code that does not depend on the program's systems. It is either compiled in
/// every file that uses it or provided by the library kanexpr::engine. In the second case,
/// KANEXPR_COMPILED_ENGINE is defined wherever the headers are included, and the headers contain only
/// declarations.
#if defined KANEXPR_COMPILED_ENGINE
#define KANEXPR_ENGINE
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENGINE", "1");
#else
#define KANEXPR_ENGINE inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_ENGINE", "2");
#endif
