#pragma once

#include <kanexpr/ensembles/run_scheduler.ipp>
#include <kanexpr/mpi/channel.ipp>
#include <kanexpr/mpi/messages.ipp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>

namespace kanexpr::mpi {

/// A rank other than the first in one study. Each of its threads requests shares from the first rank.
class other_rank {
public:
  other_rank(channel& messages, std::uint64_t study) : messages_(messages), study_(study) {}

  summary run(const ensembles::study_interface& study, unsigned threads) {
    {
      const auto others =
          ensembles::start_threads(threads - 1, [&](std::size_t i) { work(study, static_cast<int>(i) + 1); });
      work(study, 0);
    }
    try {
      if (failure_.empty()) {
        messages_.send(0, to_first, report{.wants = request::summary, .study = study_});
        return messages_.receive<summary>(0, to_rank).content;
      }
    } catch (const std::exception& thrown) {
      failure_ = thrown.what();
    }
    return {0, 0, failure_};
  }

private:
  void work(const ensembles::study_interface& study, int thread) {
    try {
      report done{.study = study_, .thread = thread};
      for (;;) {
        messages_.send(0, to_first, done);
        done.done = messages_.receive<ensembles::share>(0, to_thread + thread).content;
        if (done.done.count == 0) return;
        // Runs report errors as failed runs; without memory, the rank ends.
        done.runs = [&]() noexcept { return ensembles::perform(study, done.done, done.seconds); }();
      }
    } catch (const std::exception& thrown) {
      const std::scoped_lock lock(mutex_);
      failure_ = thrown.what();
    }
  }

  channel& messages_;
  const std::uint64_t study_;
  std::mutex mutex_{};
  std::string failure_{};
};

} // namespace kanexpr::mpi
