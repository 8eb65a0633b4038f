#pragma once

#include <kanexpr/base/file_path.hpp>
#include <kanexpr/ensembles/compiled_ensembles.hpp>
#include <kanexpr/ensembles/results_file.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <memory>

namespace kanexpr {

/// The table of runs as text, one line per run: `.files = {csv_file("study.csv")}`. It cannot hold
/// trajectories or events; the files of <kanexpr/hdf5.hpp> can.
KANEXPR_ENSEMBLES std::shared_ptr<results_file> csv_file(const file_path& path,
                                                         const csv_options& options = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensembles/csv_file.ipp>
#endif
