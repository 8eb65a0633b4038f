#pragma once

#include <kanexpr/ensemble/hdf5/compiled_hdf5.hpp>
#include <kanexpr/ensemble/results_file.hpp>
#include <kanexpr/simulate/file_path.hpp>

#include <memory>

namespace kanexpr {

struct hdf5_options {
  int compression = 0;    ///< from 1, which is fast, to 9, which is small; 0: none
  double flush_every = 5; ///< seconds, after which others can read what was written
};

/// All that a study keeps, for h5py, pandas or MATLAB: `.files = {hdf5_file("study.h5")}`. Others may read
/// the file while it is written, as what HDF5 calls SWMR readers.
///
/// It has a dataset of rows with named columns for each: `runs`, a row of each run; `failures`, with the
/// state and the cause; `samples` of all trajectories; `events`. Units are attributes of them.
KANEXPR_HDF5 std::shared_ptr<results_file> hdf5_file(const file_path& path, const hdf5_options& options = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_HDF5
#include <kanexpr/ensemble/hdf5/engine/study_file.hpp>
#endif
