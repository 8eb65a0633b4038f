#pragma once

#include <kanexpr/base/one_way.hpp>

/// What of pages does not depend on a picture is compiled by every file that uses it, or the library
/// kanexpr::animate_engine holds it: then KANEXPR_COMPILED_PAGES is defined wherever the headers are
/// included.
#if defined KANEXPR_COMPILED_PAGES
#define KANEXPR_PAGES
KANEXPR_ONE_WAY("KANEXPR_COMPILED_PAGES", "1");
#else
#define KANEXPR_PAGES inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_PAGES", "2");
#endif
