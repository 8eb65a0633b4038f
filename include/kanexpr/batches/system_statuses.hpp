#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/chunks.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace kanexpr::batches {

/// A status for each of many systems; the chunks of work set the statuses of the systems that fail.
class system_statuses {
public:
  explicit system_statuses(Eigen::Index systems)
      : all_(static_cast<std::size_t>((std::max)(systems, Eigen::Index{0}))) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(all_.size()); }
  const status& of(Eigen::Index system) const { return all_[static_cast<std::size_t>(system)]; }
  void set(Eigen::Index system, const status& s) { all_[static_cast<std::size_t>(system)] = s; }

  Eigen::Index failures() const { return failures_; }
  /// Returns the status of the first system that failed.
  status first() const {
    if (failures_ > 0)
      for (const status& s : all_)
        if (!s) return s;
    return {};
  }

  /// Divides all systems into chunks of at least `least` systems, in whole batches of `width`, and calls
  /// work(begin, end) for each; `work` returns the number of systems that failed. For each chunk that does
  /// not run to completion, for example because of an exception, calls on_unfinished(begin, end). Running a
  /// chunk again has no effect.
  template <class Executor, class Work, class OnUnfinished>
  void run(Executor&& by, Eigen::Index least, Eigen::Index width, const Work& work,
           const OnUnfinished& on_unfinished) {
    if (failures_ > 0) std::fill(all_.begin(), all_.end(), status());
    const chunks parts = chunks::of(size(), least, width);
    chunk_counter<OnUnfinished> done(*this, parts, on_unfinished);
    run_chunks(std::forward<Executor>(by), parts.count, [&](int i) {
      if (done.has(i)) return;
      const Eigen::Index begin = i * parts.length;
      done.keep(i, work(begin, (std::min)(begin + parts.length, size())));
    });
  }

  /// Marks all systems as failed, with one cause.
  status refuse(const status& why) {
    std::fill(all_.begin(), all_.end(), why);
    failures_ = size();
    return why;
  }

private:
  /// Counts the failures in each chunk; its destructor sums them, even after an exception.
  template <class OnUnfinished>
  class chunk_counter {
  public:
    chunk_counter(system_statuses& of, const chunks& parts, const OnUnfinished& on_unfinished)
        : of_(of), parts_(parts), on_unfinished_(on_unfinished) {
      failed_.fill(not_run);
    }
    chunk_counter(const chunk_counter&) = delete;
    chunk_counter& operator=(const chunk_counter&) = delete;
    ~chunk_counter() {
      of_.failures_ = 0;
      for (int i = 0; i < parts_.count; ++i) {
        const Eigen::Index begin = i * parts_.length, end = (std::min)(begin + parts_.length, of_.size());
        of_.failures_ += has(i) ? failed_[static_cast<std::size_t>(i)] : mark_unfinished(begin, end);
      }
    }

    bool has(int chunk) const { return failed_[static_cast<std::size_t>(chunk)] != not_run; }
    void keep(int chunk, Eigen::Index failed) { failed_[static_cast<std::size_t>(chunk)] = failed; }

  private:
    static constexpr Eigen::Index not_run = -1;

    Eigen::Index mark_unfinished(Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index system = begin; system < end; ++system)
        of_.set(system, status("the chunk that contains this system was not run to completion"));
      on_unfinished_(begin, end);
      return end - begin;
    }

    system_statuses& of_;
    chunks parts_;
    const OnUnfinished& on_unfinished_;
    std::array<Eigen::Index, chunks::most> failed_;
  };

  std::vector<status> all_;
  Eigen::Index failures_ = 0;
};

} // namespace kanexpr::batches
