#pragma once

#include <kanexpr/ensembles/collector.ipp>
#include <kanexpr/ensembles/run_on_threads.hpp>
#include <kanexpr/ensembles/run_scheduler.ipp>

#include <algorithm>
#include <cstddef>
#include <thread>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

KANEXPR_ENSEMBLES ensemble_results run_on_threads(const study_interface& study,
                                                  const ensemble_options& options) {
  collector results(study, options);
  if (!results.begin()) return results.end();
  const std::size_t runs = study.layout().runs, left = runs - results.done();
  const std::size_t wanted = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
  const std::size_t threads = std::clamp(wanted, std::size_t{1}, (std::max)(left, std::size_t{1}));
  run_scheduler scheduler({.runs = runs, .done = results.done(), .lanes = study.lanes(), .workers = threads},
                          options.stop,
                          [&](std::vector<finished_run>&& some) { return results.add(std::move(some)); });
  {
    const auto others = start_threads(threads - 1, [&](std::size_t) { scheduler.work(study); });
    scheduler.work(study);
  }
  return results.end();
}

} // namespace kanexpr::ensembles
