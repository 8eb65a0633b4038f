#pragma once

#include <kanexpr/base/file_path.hpp>
#include <kanexpr/ensembles/hdf5/compiled_hdf5.hpp>
#include <kanexpr/ensembles/results_file.hpp>

#include <memory>

namespace kanexpr {

/// Options of `hdf5_file`.
struct hdf5_options {
  int compression = 0;    ///< level from 1 (fastest) to 9 (smallest); 0: none
  double flush_every = 5; ///< seconds between updates that other programs see
};

/// A file of all results that a study keeps, for h5py, pandas or MATLAB: `.files = {hdf5_file("study.h5")}`.
/// Other programs may read the file while it is being written, as SWMR readers (single writer, multiple
/// readers).
///
/// The file has datasets with named columns: `runs`, with a row per run; `failures`, with state and cause;
/// `samples` of all trajectories; `events`. Their units are attributes.
///
/// HDF5 would crash at the end of a program that could not write its last data, so this function calls
/// H5dont_atexit: a program that opens HDF5 files itself must close them before it ends.
KANEXPR_HDF5 std::shared_ptr<results_file> hdf5_file(const file_path& path, const hdf5_options& options = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_HDF5
#include <kanexpr/ensembles/hdf5/study_file.ipp>
#endif
