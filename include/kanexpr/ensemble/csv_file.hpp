#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/results_file.hpp>
#include <kanexpr/simulate/file_path.hpp>

#include <memory>

namespace kanexpr {

/// The table of runs as text, a row of each: `.files = {csv_file("study.csv")}`. It has no units, and no
/// place for trajectories and the times of events, which <kanexpr/hdf5.hpp> has.
KANEXPR_ENSEMBLES std::shared_ptr<results_file> csv_file(const file_path& path);

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/csv_file.hpp>
#endif
