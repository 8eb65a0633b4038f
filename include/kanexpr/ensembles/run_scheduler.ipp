#pragma once

#include <kanexpr/ensembles/study_interface.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Consecutive runs that one worker performs.
struct share {
  std::size_t first = 0, count = 0;
  static void fields(auto& self, auto& archive) { archive(self.first, self.count); }
};

/// The results of a share, and the time that it took.
struct finished_share {
  std::size_t first = 0;
  std::vector<finished_run> runs{};
  double seconds = 0;
  static void fields(auto& self, auto& archive) { archive(self.first, self.runs, self.seconds); }
};

inline finished_share perform(const study_interface& study, const share& of) {
  const auto start = std::chrono::steady_clock::now();
  finished_share done{of.first, study.run(of.first, of.count)};
  done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

/// Distributes the runs of a study among workers, and passes their results on in the order of the runs, so
/// that nothing computed from the results depends on which worker performed a run, or when. After a stop
/// request, when the workers have finished their shares, the results passed on are those of the first runs,
/// without gaps.
///
/// All functions may be called from any thread. One thread at a time passes results on.
class run_scheduler {
public:
  /// Receives runs in order; returns false to end the study.
  using consumer = std::function<bool(std::vector<finished_run>&&)>;

  struct options {
    std::size_t runs = 0, done = 0;  ///< the first `done` runs have already been performed
    std::size_t lanes = 1;           ///< shares start and end at multiples of this number
    std::size_t workers = 1;         ///< the approximate number of workers
    double share_seconds = 0.001;    ///< the intended duration of a share
    std::size_t max_pending = 65536; ///< the number of runs that may be handed out but not yet passed on
  };

  run_scheduler(const options& how, std::stop_token stop, consumer consume)
      : options_(how), next_(how.done), passed_on_(how.done), stop_(std::move(stop)),
        consume_(std::move(consume)) {}

  /// Waits for the next share and returns it; the share has no runs if there are no more.
  share next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !gives_more() || !is_full(); });
    return give();
  }
  /// The same without waiting; empty if no share is available yet.
  std::optional<share> try_next() {
    const std::scoped_lock lock(mutex_);
    return !gives_more() || !is_full() ? std::optional(give()) : std::nullopt;
  }

  void finish(finished_share&& done) {
    std::unique_lock lock(mutex_);
    const double each = done.seconds / static_cast<double>(done.runs.size());
    seconds_per_run_ += (each - seconds_per_run_) / (seconds_per_run_ > 0 ? 8 : 1);
    finished_.emplace(done.first, std::move(done.runs));
    --open_;
    if (!is_passing_on_) pass_on(lock);
  }

  /// Performs shares on the calling thread until there are no more.
  void work(const study_interface& study) {
    for (share one = next(); one.count > 0; one = next()) finish(perform(study, one));
  }

  /// True if all shares are finished and passed on, and there will be no more.
  bool is_over() {
    const std::scoped_lock lock(mutex_);
    return !gives_more() && open_ == 0 && !is_passing_on_;
  }
  /// Stops handing out shares.
  void end() {
    const std::scoped_lock lock(mutex_);
    is_ended_ = true;
    changed_.notify_all();
  }

private:
  bool gives_more() const { return next_ < options_.runs && !is_ended_ && !stop_.stop_requested(); }
  bool is_full() const { return next_ - passed_on_ >= options_.max_pending; }

  share give() {
    if (!gives_more()) return {};
    std::size_t count = 1; // until the duration of a run is known
    if (seconds_per_run_ > 0) {
      const std::size_t most =
          (std::min)((options_.runs - next_) / (4 * options_.workers) + 1, options_.max_pending / 4);
      const double in_time = options_.share_seconds / seconds_per_run_;
      count =
          in_time < static_cast<double>(most) ? (std::max)(static_cast<std::size_t>(in_time), count) : most;
    }
    const std::size_t first = next_, lanes = options_.lanes;
    next_ = (std::min)((first + count + lanes - 1) / lanes * lanes, options_.runs);
    ++open_;
    return {first, next_ - first};
  }

  void pass_on(std::unique_lock<std::mutex>& lock) {
    is_passing_on_ = true;
    while (!finished_.empty() && finished_.begin()->first == passed_on_) {
      std::vector<finished_run> runs = std::move(finished_.begin()->second);
      finished_.erase(finished_.begin());
      const std::size_t count = runs.size();
      lock.unlock();
      const bool continues = consume_(std::move(runs));
      lock.lock();
      passed_on_ += count;
      is_ended_ |= !continues;
      changed_.notify_all();
    }
    is_passing_on_ = false;
  }

  const options options_;
  std::mutex mutex_{};
  std::condition_variable changed_{};
  std::size_t next_, passed_on_;
  std::size_t open_ = 0;                                        ///< shares handed out and not finished
  std::map<std::size_t, std::vector<finished_run>> finished_{}; ///< by their first run
  double seconds_per_run_ = 0;                                  ///< a moving average; 0 while unknown
  bool is_passing_on_ = false, is_ended_ = false;
  std::stop_token stop_;
  consumer consume_;
};

/// Starts threads that call `work` with their numbers; fewer if the system cannot start all of them.
template <class Work>
std::vector<std::jthread> start_threads(std::size_t count, const Work& work) {
  std::vector<std::jthread> threads;
  try {
    while (threads.size() < count) threads.emplace_back(work, threads.size());
  } catch (const std::system_error&) {
    return threads;
  }
  return threads;
}

} // namespace kanexpr::ensembles
