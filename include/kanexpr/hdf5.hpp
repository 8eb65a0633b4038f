#pragma once

/// Results of ensembles in files of HDF5. Link kanexpr::hdf5.

#include <kanexpr/compiler.hpp>

#include <kanexpr/ensemble/hdf5/hdf5_file.hpp>
