#pragma once

#include <kanexpr/ensembles/run_scheduler.ipp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kanexpr::mpi {

/// The tags of messages: to the first rank, from it to a rank, and from it to each thread of a rank.
enum tag : int { to_first = 0, to_rank = 1, to_thread = 2 };

/// The messages to the first rank: a thread requests a share, a rank has no more threads at work and waits
/// for the summary of the study, or a rank takes part in no more studies.
enum class request : std::uint8_t { share, summary, leave };

/// The message to the first rank. A thread that requests a share reports the results of the one before.
struct report {
  request wants = request::share;
  std::uint64_t study = 0; ///< the hash of its identity
  int thread = 0;
  ensembles::share done{};
  double seconds = 0;
  std::vector<finished_run> runs{};

  static void fields(auto& self, auto& archive) {
    archive(self.wants, self.study, self.thread, self.done, self.seconds, self.runs);
  }
};

/// The result of a study, for ranks other than the first.
struct summary {
  std::size_t done = 0, failed = 0;
  std::string failure{};

  static void fields(auto& self, auto& archive) { archive(self.done, self.failed, self.failure); }
};

} // namespace kanexpr::mpi
