#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batch/chunks.hpp>

#include <array>
#include <vector>

namespace kanexpr::batches {

/// A status for each of many systems, of which chunks of work set those that failed.
class system_statuses {
public:
  explicit system_statuses(Eigen::Index systems) : all_(static_cast<std::size_t>(systems)) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(all_.size()); }
  const status& of(Eigen::Index system) const { return all_[static_cast<std::size_t>(system)]; }
  void set(Eigen::Index system, const status& s) { all_[static_cast<std::size_t>(system)] = s; }

  Eigen::Index failures() const { return failures_; }
  /// Of the first system that failed.
  status first() const {
    if (failures_ > 0)
      for (const status& s : all_)
        if (!s) return s;
    return {};
  }

  /// Runs work(begin, end) for all systems, with no less than `least` of them in a chunk. It returns how many
  /// failed.
  template <class Executor, class Work>
  void run(Executor&& by, Eigen::Index least, const Work& work) {
    if (failures_ > 0) std::fill(all_.begin(), all_.end(), status());
    constexpr Eigen::Index not_run = -1;
    const chunks parts = chunks::of(size(), least);
    std::array<Eigen::Index, chunks::most> failed;
    failed.fill(not_run);
    run_chunks(std::forward<Executor>(by), parts.count, [&](int i) {
      const Eigen::Index begin = i * parts.length, end = (std::min)(begin + parts.length, size());
      failed[static_cast<std::size_t>(i)] = work(begin, end);
    });
    failures_ = 0;
    for (int i = 0; i < parts.count; ++i) {
      Eigen::Index in_chunk = failed[static_cast<std::size_t>(i)];
      if (in_chunk == not_run) in_chunk = leave(i * parts.length, (std::min)((i + 1) * parts.length, size()));
      failures_ += in_chunk;
    }
  }

  /// All have failed, for one reason.
  status refuse(const status& why) {
    std::fill(all_.begin(), all_.end(), why);
    failures_ = size();
    return why;
  }

private:
  Eigen::Index leave(Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index system = begin; system < end; ++system)
      set(system, status("the chunk of this system was not run"));
    return end - begin;
  }

  std::vector<status> all_;
  Eigen::Index failures_ = 0;
};

} // namespace kanexpr::batches
