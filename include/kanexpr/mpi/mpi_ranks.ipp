#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensembles/collector.ipp>
#include <kanexpr/ensembles/run_scheduler.ipp>
#include <kanexpr/mpi/channel.ipp>
#include <kanexpr/mpi/mpi_ranks.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace mpi {

/// The first rank in one study: distributes the runs, performs some of them, and collects the results. All
/// other ranks wait for it at the end of a study, except those that have left.
class first_rank {
  using scheduler = ensembles::run_scheduler;

public:
  first_rank(channel& messages, std::set<int>& absent, std::uint64_t study)
      : messages_(messages), absent_(absent), study_(study) {}

  ensemble_results run(const ensembles::study_interface& study, const ensemble_options& options) {
    ensembles::collector results(study, options);
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
        messages_.send(each, to_rank, summary{0, 0, "the first rank ended without performing this study"});
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
      } else if (!reported.done.runs.empty()) {
        shares.finish(std::move(reported.done));
      }
      idle_.emplace_back(one.from, reported.thread);
    }
  }

  /// Hands out shares to idle threads unless too many runs are pending.
  void answer(scheduler& shares) {
    while (!idle_.empty()) {
      const auto next = shares.try_next();
      if (!next) return;
      const auto [rank, thread] = idle_.front();
      idle_.pop_front();
      messages_.send(rank, to_thread + thread, *next);
    }
  }

  channel& messages_;
  std::set<int>& absent_; ///< ranks that no longer take part in studies
  const std::uint64_t study_;
  std::deque<std::pair<int, int>> idle_{}; ///< rank and thread
  std::vector<int> finished_{};            ///< ranks that wait for the summary
  std::string failure_{};
};

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
        const auto next = messages_.receive<ensembles::share>(0, to_thread + thread).content;
        if (next.count == 0) return;
        // An error in a run is reported as a failed run; if memory runs out, the rank terminates.
        done.done = [&]() noexcept { return ensembles::perform(study, next); }();
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

} // namespace mpi

struct mpi_ranks::state {
  std::optional<mpi::channel> messages{};
  std::set<int> absent{}; ///< known to the first rank
};

KANEXPR_MPI mpi_ranks::mpi_ranks(int& argc, char**& argv) : state_(std::make_unique<state>()) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED)
    throw std::runtime_error(
        "this MPI library does not support calls from several threads (MPI_THREAD_SERIALIZED)");
  state_->messages.emplace();
}

KANEXPR_MPI mpi_ranks::~mpi_ranks() {
  try {
    if (is_first())
      mpi::first_rank(*state_->messages, state_->absent, 0).serve_without_study();
    else
      state_->messages->send(0, mpi::to_first, mpi::report{.wants = mpi::request::leave});
  } catch (const std::exception&) { // MPI_Finalize would wait forever for ranks that cannot be reached
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  state_->messages.reset();
  MPI_Finalize();
}

KANEXPR_MPI int mpi_ranks::rank() const { return state_->messages->rank(); }
KANEXPR_MPI int mpi_ranks::count() const { return state_->messages->ranks(); }

KANEXPR_MPI ensemble_results mpi_ranks::run(const ensembles::study_interface& study,
                                            const ensemble_options& options) {
  const std::uint64_t hash = content_hash(ensembles::identity_of(study));
  if (is_first()) return mpi::first_rank(*state_->messages, state_->absent, hash).run(study, options);
  mpi::summary all =
      mpi::other_rank(*state_->messages, hash).run(study, options.threads > 0 ? options.threads : 1);
  ensemble_results found;
  found.planned = study.layout().runs;
  found.done = all.done, found.failed = all.failed, found.failure = std::move(all.failure);
  return found;
}

} // namespace kanexpr
