#pragma once

#include <kanexpr/base/one_way.hpp>

/// The parts of pages that do not depend on a picture are compiled in every file that uses them, or once in
/// the library kanexpr::animate_engine; in the latter case, KANEXPR_COMPILED_PAGES is defined wherever the
/// headers are included.
#if defined KANEXPR_COMPILED_PAGES
#define KANEXPR_PAGES
KANEXPR_ONE_WAY("KANEXPR_COMPILED_PAGES", "1");
#else
#define KANEXPR_PAGES inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_PAGES", "2");
#endif
