#pragma once

#include <kanexpr/base/one_way.hpp>

/// Every file that writes HDF5 sees its headers, with their macros, or the library kanexpr::hdf5_engine holds
/// what does: then KANEXPR_COMPILED_HDF5 is defined wherever the headers are included.
#if defined KANEXPR_COMPILED_HDF5
#define KANEXPR_HDF5
KANEXPR_ONE_WAY("KANEXPR_COMPILED_HDF5", "1");
#else
#define KANEXPR_HDF5 inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_HDF5", "2");
#endif
