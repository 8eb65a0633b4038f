#pragma once

/// Ensemble results in HDF5 files. Link kanexpr::hdf5.

#include <kanexpr/compiler.hpp>

#include <kanexpr/ensembles/hdf5/hdf5_file.hpp>
