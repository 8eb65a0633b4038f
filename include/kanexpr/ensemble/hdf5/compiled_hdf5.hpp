#pragma once

/// Every file that writes HDF5 sees its headers, with their macros, or the library kanexpr::hdf5_engine holds
/// what does: then KANEXPR_COMPILED_HDF5 is defined wherever the headers are included.
#if defined KANEXPR_COMPILED_HDF5
#define KANEXPR_HDF5
#else
#define KANEXPR_HDF5 inline
#endif
