#pragma once

/// The version of the library.

#define KANEXPR_VERSION_MAJOR 0
#define KANEXPR_VERSION_MINOR 2
#define KANEXPR_VERSION_PATCH 0

/// The version as one number for comparisons, 10203 for 1.2.3: `#if KANEXPR_VERSION >= 200`.
#define KANEXPR_VERSION (KANEXPR_VERSION_MAJOR * 10000 + KANEXPR_VERSION_MINOR * 100 + KANEXPR_VERSION_PATCH)
