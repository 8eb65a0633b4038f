#pragma once

#include <kanexpr/base/one_way.hpp>

/// The code for HDF5 is compiled in every file that uses it, which then sees the macros of HDF5, or only
/// once, in the library kanexpr::hdf5_engine, which defines KANEXPR_COMPILED_HDF5 for all its users.
#if defined KANEXPR_COMPILED_HDF5
#define KANEXPR_HDF5
KANEXPR_ONE_WAY("KANEXPR_COMPILED_HDF5", "1");
#else
#define KANEXPR_HDF5 inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_HDF5", "2");
#endif
