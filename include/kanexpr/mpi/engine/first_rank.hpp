#pragma once

#include <kanexpr/ensemble/collector.hpp>
#include <kanexpr/ensemble/sharing.hpp>
#include <kanexpr/mpi/engine/patience.hpp>
#include <kanexpr/mpi/mailbox.hpp>
#include <kanexpr/mpi/worker_threads.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::mpi {

/// The rank that shares out the runs of one study, and takes what they leave.
class first_rank {
public:
  first_rank(mailbox& post, const mpi_options& options, std::uint64_t study, std::uint64_t known_by)
      : post_(post), options_(options), study_(study), known_by_(known_by),
        others_(static_cast<std::size_t>(post.ranks())) {}

  /// Its own threads come home when it is gone, as the others wait for what came of the study.
  ensemble_results run(const ensembles::job& study, const std::string& known_by,
                       const ensemble_options& options) {
    ensembles::collector results(study.layout(), known_by, options);
    if (results.begin()) share_out(study, results, options);
    ensemble_results found = results.end();
    if (found.failure.empty()) found.failure = failure_;
    return found;
  }

  /// Those of which nothing is heard any more.
  std::vector<std::int64_t> lost() const {
    std::vector<std::int64_t> all;
    for (std::size_t i = 0; i < others_.size(); ++i)
      if (others_[i].is_lost) all.push_back(static_cast<std::int64_t>(i));
    return all;
  }

private:
  struct other {
    std::size_t room = 0; ///< 0: it has never been heard of
    std::vector<ensembles::share> holds{};
    clock::time_point heard{}, told{};
    clock::time_point gave{}; ///< back a share, as the last time
    bool is_lost = false, waits = false;
  };

  void share_out(const ensembles::job& study, ensembles::collector& results,
                 const ensemble_options& options) {
    const std::size_t threads = (std::max)(options.threads, 1u), all = threads * others_.size();
    ensembles::sharing shares(
        {.runs = study.layout().runs,
         .done = results.done(),
         .side_by_side = study.side_by_side(),
         .takers = all,
         .seconds_of_share = 0.05,
         .most_ahead = (std::max)(std::size_t{65536}, 512 * all)},
        options.stop, [&](std::vector<finished_run>&& runs) { return results.take(std::move(runs)); });
    worker_threads& own = own_.emplace(study, threads);
    nap rest;
    while (!shares.is_over() && failure_.empty()) {
      bool was_idle = true;
      while (const auto come = post_.receive()) take(*come, shares), was_idle = false;
      for (ensembles::finished_share& each : own.finished())
        finish(std::move(each), shares), was_idle = false;
      if (seconds_since(looked_) > 0.01) look_after(shares, study.layout());
      give(shares, own);
      if (was_idle)
        own.wait(rest.next());
      else
        rest.reset();
    }
  }

  void take(const letter& come, ensembles::sharing& shares) {
    if (come.kind != kind_of_message::report) return;
    auto told = come.read<report>();
    if (told.study != study_) return;
    if (told.known_by != known_by_) {
      failure_ = "rank " + std::to_string(come.from) +
                 " has another study than the first one, or another build of the program";
      return;
    }
    other& from = others_[static_cast<std::size_t>(come.from)];
    if (from.room == 0 || !told.done.empty()) from.gave = clock::now();
    from.heard = clock::now(), from.is_lost = false, from.room = told.room;
    for (ensembles::finished_share& each : told.done) {
      std::erase_if(from.holds, [&](const auto& held) { return held.first == each.what.first; });
      finish(std::move(each), shares);
    }
    wait_for_more(come.from, from);
    if (seconds_since(from.told) > seconds_of_sign(options_)) tell(come.from, from, {});
  }

  void finish(ensembles::finished_share&& one, ensembles::sharing& shares) {
    shares.finish(one.what, std::move(one.runs), one.seconds);
    last_finished_ = clock::now();
  }

  void wait_for_more(int rank, other& one) {
    if (one.waits || one.holds.size() >= one.room) return;
    one.waits = true;
    waiting_.push_back(rank);
  }

  void tell(int rank, other& to, std::vector<ensembles::share> what) {
    post_.send(rank, orders{study_, std::move(what)});
    to.told = clock::now();
  }

  /// Takes from those that are lost what they hold, and lets go of what nobody survives.
  void look_after(ensembles::sharing& shares, const study_layout& layout) {
    looked_ = clock::now();
    asks_again_ = true;
    for (other& each : others_) {
      if (each.room == 0 || each.is_lost || seconds_since(each.heard) <= options_.silence) continue;
      each.is_lost = true;
      for (const ensembles::share& held : each.holds) shares.lose(held);
      each.holds.clear();
    }
    while (const auto one = shares.hopeless(options_.patience)) {
      std::vector<finished_run> none;
      none.reserve(one->count);
      for (std::size_t i = 0; i < one->count; ++i) none.push_back(unfinished(one->first + i, layout));
      shares.finish(*one, std::move(none), 0.0);
    }
    if (seconds_since(last_finished_) > 4 * options_.patience)
      failure_ = "no run has ended for " + std::to_string(std::llround(4 * options_.patience)) + " seconds";
  }

  static finished_run unfinished(std::size_t run, const study_layout& layout) {
    finished_run one;
    one.run = run, one.end = run_end::failed, one.time = std::numeric_limits<double>::quiet_NaN();
    one.values.assign(layout.columns.size(), one.time);
    one.values[0] = static_cast<double>(run), one.values[1] = static_cast<double>(one.end);
    one.failure = "nobody has finished the run, each time it was given out: the ranks that did it were lost, "
                  "or it takes longer than they have patience";
    return one;
  }

  void give(ensembles::sharing& shares, worker_threads& own) {
    for (std::size_t left = waiting_.size(); left > 0; --left) {
      const int rank = waiting_.front();
      waiting_.pop_front();
      other& one = others_[static_cast<std::size_t>(rank)];
      one.waits = false;
      if (one.is_lost) continue;
      std::vector<ensembles::share> what;
      while (one.holds.size() < one.room) {
        const auto next = next_for_others(shares);
        if (!next) break;
        what.push_back(*next), one.holds.push_back(*next);
      }
      wait_for_more(rank, one);
      if (what.empty()) break;
      tell(rank, one, std::move(what));
    }
    while (own.held() < own.room()) {
      auto next = shares.next_at_once();
      // What has ended another rank may end this one too, and with it the study.
      if (!next && own.held() == 0 && is_alone()) next = next_for_others(shares);
      if (!next) break;
      own.give(*next);
    }
  }

  /// Whether no other rank can do anything.
  bool is_alone() const {
    return std::ranges::all_of(others_, [&](const other& each) {
      const bool is_stuck = each.holds.size() >= each.room && seconds_since(each.gave) > options_.patience;
      return each.room == 0 || each.is_lost || is_stuck;
    });
  }

  std::optional<ensembles::share> next_for_others(ensembles::sharing& shares) {
    if (asks_again_)
      if (const auto again = shares.overdue(options_.patience)) return again;
    asks_again_ = false; // for a while, as it takes a look at all shares
    return shares.next_at_once();
  }

  mailbox& post_;
  const mpi_options& options_;
  const std::uint64_t study_, known_by_;
  std::vector<other> others_; ///< by rank; the first is this one
  std::deque<int> waiting_{}; ///< for shares
  clock::time_point looked_ = clock::now(), last_finished_ = looked_;
  bool asks_again_ = false;
  std::string failure_{};
  std::optional<worker_threads> own_{};
};

} // namespace kanexpr::mpi
