#pragma once

#include <kanexpr/ensemble/job.hpp>
#include <kanexpr/ensemble/sharing.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace kanexpr::mpi {

/// The threads of a rank that do shares, while another one looks after messages.
class worker_threads {
public:
  worker_threads(const ensembles::job& study, std::size_t threads)
      : room_(2 * threads), shared_(std::make_shared<shared>(study)) {
    shared_->running = threads;
    for (std::size_t i = 0; i < threads; ++i) std::thread(work, shared_).detach();
  }

  worker_threads(const worker_threads&) = delete;
  worker_threads& operator=(const worker_threads&) = delete;
  /// Forgets what was not begun, and waits for the threads for a moment: one whose run never ends is left
  /// behind.
  ~worker_threads() {
    std::unique_lock lock(shared_->mutex);
    shared_->is_over = true;
    shared_->may_work.notify_all();
    shared_->is_done.wait_for(lock, std::chrono::seconds(2), [&] { return shared_->running == 0; });
  }

  /// How many shares they hold at a time, so that each thread finds the next one there.
  std::size_t room() const { return room_; }
  /// How many they hold.
  std::size_t held() const { return held_; }

  void give(const ensembles::share& one) {
    ++held_;
    const std::scoped_lock lock(shared_->mutex);
    shared_->to_do.push_back(one);
    shared_->may_work.notify_one();
  }

  /// What has been done since it was asked last.
  std::vector<ensembles::finished_share> finished() {
    const std::scoped_lock lock(shared_->mutex);
    held_ -= shared_->done.size();
    return std::exchange(shared_->done, {});
  }

  /// Waits until something is done, at most so long.
  void wait(std::chrono::microseconds most) {
    std::unique_lock lock(shared_->mutex);
    shared_->is_done.wait_for(lock, most, [&] { return !shared_->done.empty(); });
  }

private:
  struct shared {
    explicit shared(const ensembles::job& told) : study(told), kept(told.itself.lock()) {}
    const ensembles::job& study;
    const std::shared_ptr<const ensembles::job> kept; ///< for threads that are left behind
    std::mutex mutex{};
    std::condition_variable may_work{}, is_done{};
    std::deque<ensembles::share> to_do{};
    std::vector<ensembles::finished_share> done{};
    std::size_t running = 0;
    bool is_over = false;
  };

  static void work(const std::shared_ptr<shared>& all) {
    std::unique_lock lock(all->mutex);
    for (;;) {
      all->may_work.wait(lock, [&] { return all->is_over || !all->to_do.empty(); });
      if (all->is_over) break;
      ensembles::finished_share one{all->to_do.front()};
      all->to_do.pop_front();
      lock.unlock();
      const auto begun = std::chrono::steady_clock::now();
      one.runs = all->study.run(one.what.first, one.what.count);
      one.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      lock.lock();
      all->done.push_back(std::move(one));
      all->is_done.notify_all();
    }
    --all->running;
    all->is_done.notify_all();
  }

  std::size_t room_, held_ = 0;
  std::shared_ptr<shared> shared_;
};

} // namespace kanexpr::mpi
