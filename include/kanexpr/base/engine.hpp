#pragma once

/// What works while a program runs and does not depend on its systems is the engine. Every file that uses it
/// compiles it, or the library kanexpr::engine holds it: then KANEXPR_COMPILED_ENGINE is defined wherever the
/// headers are included, and they declare what the library defines.
#if defined KANEXPR_COMPILED_ENGINE
#define KANEXPR_ENGINE
#else
#define KANEXPR_ENGINE inline
#endif
