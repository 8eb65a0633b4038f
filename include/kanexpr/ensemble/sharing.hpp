#pragma once

#include <kanexpr/ensemble/finished_run.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Some runs, one after another.
struct share {
  std::size_t first = 0, count = 0;
};

/// What the runs of a share left.
struct finished_share {
  share what{};
  double seconds = 0; ///< that they took
  std::vector<finished_run> runs{};
};

/// Gives out the runs of a study, in their order, to those who ask, and hands on what they leave, in the same
/// order: so nothing that is formed of it depends on who did what and when. When those who took shares have
/// finished them, what was handed on are all runs up to one of them, also if the study was asked to stop.
///
/// Any thread may call it. One of them at a time hands on, while the others go on with theirs.
class sharing {
  using clock = std::chrono::steady_clock;

public:
  /// Takes runs in order; false: no more are wanted.
  using taker = std::function<bool(std::vector<finished_run>&&)>;

  struct how {
    std::size_t runs = 0, done = 0; ///< the first so many are done already
    std::size_t side_by_side = 1;   ///< shares begin and end at multiples of this
    std::size_t takers = 1;         ///< about so many take shares
    double seconds_of_share = 0.001;
    std::size_t most_ahead = 65536; ///< so many runs may be given out and not handed on yet
    int most_tries = 3;             ///< then a run is hopeless
  };

  sharing(const how& wanted, std::stop_token stop, taker take)
      : how_(wanted), given_(wanted.done), handed_on_(wanted.done), stop_(std::move(stop)),
        take_(std::move(take)) {}

  /// The next share; none: there are no more.
  std::optional<share> next() {
    std::unique_lock lock(mutex_);
    may_go_on_.wait(lock, [&] { return !gives_more() || !is_too_far_ahead(); });
    return gives_more() ? std::optional(give()) : std::nullopt;
  }

  /// The same without waiting, for one who has others to look after: none, for now or for ever.
  std::optional<share> next_at_once() {
    const std::scoped_lock lock(mutex_);
    return gives_more() && !is_too_far_ahead() ? std::optional(give()) : std::nullopt;
  }

  /// Nobody will finish what is open of a share, as who took it is lost.
  void lose(const share& lost) {
    const std::scoped_lock lock(mutex_);
    for_open_in(lost, [](auto at) { at->second.is_lost = true; });
  }

  /// What was lost, or given out longer than so many seconds ago, once more; both may finish it, as what a
  /// run leaves depends on nothing but its number. It comes in the smallest shares, and of those that are
  /// tried for the last time one after another, so that a run that nobody survives takes few others along.
  std::optional<share> overdue(double seconds) {
    const std::scoped_lock lock(mutex_);
    const bool is_last_out =
        std::ranges::any_of(open_, [&](const auto& each) { return is_last(each.second); });
    for (auto at = open_.begin(); at != open_.end(); ++at) {
      open_share& one = at->second;
      if (!is_missing(one, seconds) || is_last(one) || (is_last_out && one.tries + 1 >= how_.most_tries))
        continue;
      divide(at);
      one.given = clock::now(), one.is_lost = false, ++one.tries;
      return share{at->first, one.count};
    }
    return std::nullopt;
  }

  /// A share that is missing again after its last try, and that nobody is given any more.
  std::optional<share> hopeless(double seconds) {
    const std::scoped_lock lock(mutex_);
    for (const auto& [first, one] : open_)
      if (is_last(one) && is_missing(one, seconds)) return share{first, one.count};
    return std::nullopt;
  }

  /// What the runs of a share left, and how many seconds they took if it was not the time since they were
  /// given out.
  void finish(const share& done, std::vector<finished_run>&& left, std::optional<double> seconds = {}) {
    std::unique_lock lock(mutex_);
    bool was_open = false;
    for_open_in(done, [&](auto at) {
      if (!was_open)
        learn(seconds.value_or(seconds_since(at->second.given)) / static_cast<double>(done.count));
      was_open = true;
      const auto from = left.begin() + static_cast<std::ptrdiff_t>(at->first - done.first);
      const auto to = from + static_cast<std::ptrdiff_t>(at->second.count);
      waiting_.emplace(at->first, std::vector(std::move_iterator(from), std::move_iterator(to)));
      open_.erase(at);
    });
    if (was_open && !hands_on_) hand_on(lock); // else another one was faster
  }

  /// Whether all that was given out has been handed on, and nothing more will be given.
  bool is_over() {
    const std::scoped_lock lock(mutex_);
    return !gives_more() && open_.empty() && !hands_on_;
  }

  /// Gives out no more.
  void end() {
    const std::scoped_lock lock(mutex_);
    is_ended_ = true;
    may_go_on_.notify_all();
  }

private:
  struct open_share {
    std::size_t count;
    clock::time_point given;
    int tries = 1;
    bool is_lost = false;
  };
  using open_shares = std::map<std::size_t, open_share>;

  static double seconds_since(clock::time_point then) {
    return std::chrono::duration<double>(clock::now() - then).count();
  }
  bool is_last(const open_share& one) const { return one.tries >= how_.most_tries; }
  static bool is_missing(const open_share& one, double seconds) {
    return one.is_lost || seconds_since(one.given) > seconds;
  }

  template <class Function>
  void for_open_in(const share& whole, Function each) {
    for (auto at = open_.lower_bound(whole.first);
         at != open_.end() && at->first < whole.first + whole.count;)
      each(at++);
  }

  /// Leaves the smallest share there, and what follows as shares of their own.
  void divide(open_shares::iterator at) {
    const auto [first, whole] = *at;
    open_share part = whole;
    for (std::size_t from = first, end = first + whole.count; from < end; from += part.count) {
      part.count = (std::min)(end, (from / how_.side_by_side + 1) * how_.side_by_side) - from;
      open_.insert_or_assign(from, part);
    }
  }

  /// How long a run takes.
  void learn(double seconds) {
    seconds_of_run_ += (seconds - seconds_of_run_) / (seconds_of_run_ > 0 ? 8 : 1);
  }

  bool gives_more() const { return given_ < how_.runs && !is_ended_ && !stop_.stop_requested(); }
  bool is_too_far_ahead() const { return given_ - handed_on_ >= how_.most_ahead; }

  share give() {
    const std::size_t left = how_.runs - given_, together = how_.side_by_side;
    std::size_t count = 1; // until it is known how long a run takes
    if (seconds_of_run_ > 0) {
      const double in_time = how_.seconds_of_share / seconds_of_run_;
      const std::size_t most = (std::min)(left / (4 * how_.takers) + 1, how_.most_ahead / 4);
      count =
          in_time < static_cast<double>(most) ? (std::max)(static_cast<std::size_t>(in_time), count) : most;
    }
    const std::size_t end = (std::min)((given_ + count + together - 1) / together * together, how_.runs);
    const share one{given_, end - given_};
    open_.emplace(one.first, open_share{one.count, clock::now(), 1, false});
    given_ = end;
    return one;
  }

  void hand_on(std::unique_lock<std::mutex>& lock) {
    hands_on_ = true;
    while (!waiting_.empty() && waiting_.begin()->first == handed_on_) {
      std::vector<finished_run> runs = std::move(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      const std::size_t count = runs.size();
      lock.unlock();
      const bool goes_on = take_(std::move(runs));
      lock.lock();
      handed_on_ += count;
      is_ended_ |= !goes_on;
      may_go_on_.notify_all();
    }
    hands_on_ = false;
  }

  const how how_;
  std::mutex mutex_{};
  std::condition_variable may_go_on_{};
  std::size_t given_, handed_on_;
  open_shares open_{};
  std::map<std::size_t, std::vector<finished_run>> waiting_{}; ///< finished, before those ahead of them
  double seconds_of_run_ = 0;                                  ///< as it is of late; 0: nobody knows
  bool hands_on_ = false, is_ended_ = false;
  std::stop_token stop_;
  taker take_;
};

} // namespace kanexpr::ensembles
