#pragma once

#include <kanexpr/ensemble/collector.hpp>
#include <kanexpr/ensemble/on_threads.hpp>
#include <kanexpr/ensemble/sharing.hpp>

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

KANEXPR_ENSEMBLES ensemble_results on_threads::run(const job& study, const std::string& known_by,
                                                   const ensemble_options& options) {
  collector results(study.layout(), known_by, options);
  if (!results.begin()) return results.end();
  const std::size_t left = study.layout().runs - results.done();
  const std::size_t asked = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
  const std::size_t threads = (std::max)((std::min)(asked, left), std::size_t{1});
  sharing shares({.runs = study.layout().runs,
                  .done = results.done(),
                  .side_by_side = study.side_by_side(),
                  .takers = threads},
                 options.stop,
                 [&](std::vector<finished_run>&& runs) { return results.take(std::move(runs)); });
  const auto work = [&] {
    while (const auto share = shares.next()) shares.finish(*share, study.run(share->first, share->count));
  };
  {
    std::vector<std::jthread> others;
    for (bool are_there = true; are_there && others.size() + 1 < threads;) try {
        others.emplace_back(work);
      } catch (const std::system_error&) {
        are_there = false; // fewer do it too
      }
    work();
  }
  return results.end();
}

} // namespace kanexpr::ensembles
