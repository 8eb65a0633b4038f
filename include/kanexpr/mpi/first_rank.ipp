#pragma once

#include <kanexpr/ensembles/collector.ipp>
#include <kanexpr/ensembles/run_scheduler.ipp>
#include <kanexpr/mpi/channel.ipp>
#include <kanexpr/mpi/messages.ipp>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <exception>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::mpi {

/// The first rank in one study: distributes the runs, performs some of them, and collects the results. All
/// other ranks wait for it at the end of a study, except those that have left.
class first_rank {
  using scheduler = ensembles::run_scheduler;

public:
  first_rank(channel& messages, std::set<int>& absent, std::uint64_t study)
      : messages_(messages), absent_(absent), study_(study) {}

  ensemble_results run(const ensembles::study_interface& study, const std::string& identity,
                       const ensemble_options& options) {
    ensembles::collector results(study.layout(), identity, options);
    const bool can_begin = results.begin();
    const std::size_t threads = (std::max)(options.threads, 1u);
    const std::size_t workers = threads * static_cast<std::size_t>(messages_.ranks());
    scheduler shares({.runs = study.layout().runs,
                      .done = results.done(),
                      .lanes = study.lanes(),
                      .workers = workers,
                      .share_seconds = 0.05,
                      .max_pending = (std::max)(std::size_t{65536}, 512 * workers)},
                     options.stop,
                     [&](std::vector<finished_run>&& runs) { return results.add(std::move(runs)); });
    if (!can_begin) shares.end();
    {
      const auto own = ensembles::start_threads(threads, [&](std::size_t) { shares.work(study); });
      attempt([&] { serve(shares); });
      shares.end();
    }
    ensemble_results found = results.end();
    if (found.failure.empty()) found.failure = failure_;
    attempt([&] {
      for (const int each : finished_)
        messages_.send(each, to_rank, summary{found.done, found.failed, found.failure});
    });
    return found;
  }

  /// Answers ranks that still expect studies, until all have left.
  void serve_without_study() {
    scheduler none({}, {}, {});
    while (static_cast<int>(absent_.size()) + 1 < messages_.ranks()) {
      take(messages_.receive<report>(MPI_ANY_SOURCE, to_first), none);
      answer(none);
      for (const int each : finished_)
        messages_.send(each, to_rank, summary{0, 0, "the first rank has ended without this study"});
      finished_.clear();
    }
  }

private:
  template <class Step>
  void attempt(const Step& step) {
    try {
      step();
    } catch (const std::exception& thrown) {
      failure_ = thrown.what();
    }
  }

  void serve(scheduler& shares) {
    const auto is_complete = [&] {
      return static_cast<int>(finished_.size() + absent_.size()) + 1 == messages_.ranks() && shares.is_over();
    };
    for (int tries = 0; !is_complete(); ++tries) {
      if (auto one = messages_.try_receive<report>(MPI_ANY_SOURCE, to_first)) {
        take(*std::move(one), shares);
        tries = 0;
      }
      answer(shares);
      if (tries > 0) channel::pause(tries);
    }
  }

  void take(message<report> one, scheduler& shares) {
    report& reported = one.content;
    if (reported.wants == request::leave) {
      absent_.insert(one.from);
    } else if (reported.wants == request::summary) {
      finished_.push_back(one.from);
    } else {
      if (reported.study != study_) {
        failure_ = "rank " + std::to_string(one.from) + " runs a different study from the first rank";
        shares.end();
      } else if (reported.done.count > 0) {
        shares.finish(reported.done, std::move(reported.runs), reported.seconds);
      }
      idle_.emplace_back(one.from, reported.thread);
    }
  }

  /// Gives shares to idle threads, and an empty one to each if there are no more.
  void answer(scheduler& shares) {
    while (!idle_.empty()) {
      const auto next = shares.try_next();
      if (!next && shares.has_more()) return; // later, as too many runs are pending
      const auto [rank, thread] = idle_.front();
      idle_.pop_front();
      messages_.send(rank, to_thread + thread, next.value_or(ensembles::share{}));
    }
  }

  channel& messages_;
  std::set<int>& absent_; ///< ranks that take part in no more studies
  const std::uint64_t study_;
  std::deque<std::pair<int, int>> idle_{}; ///< rank and thread
  std::vector<int> finished_{};            ///< ranks that wait for the summary
  std::string failure_{};
};

} // namespace kanexpr::mpi
