#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace bench {

/// A second thread that waits for its half of the chunks: awake for a while, as those of OpenMP do, since
/// waking it takes longer than the work.
class two_threads {
public:
  two_threads() : other_([this](const std::stop_token& stop) { run(stop); }) {}
  two_threads(const two_threads&) = delete;
  two_threads& operator=(const two_threads&) = delete;
  ~two_threads() {
    other_.request_stop();
    hand(this);
  }

  template <class Chunk>
  void operator()(int count, const Chunk& chunk) {
    const auto from = [&](int first) {
      for (int i = first; i < count; i += 2) chunk(i);
    };
    call_ = [](const void* of, int first) { (*static_cast<const decltype(from)*>(of))(first); };
    hand(&from);
    from(0);
    wait_while(&from);
  }

private:
  void hand(const void* work) {
    work_ = work;
    work_.notify_all();
  }
  void wait_while(const void* work) const {
    for (int turn = 0; turn < 100'000; ++turn)
      if (work_.load(std::memory_order_acquire) != work) return;
    work_.wait(work);
  }
  void run(const std::stop_token& stop) {
    for (;;) {
      wait_while(nullptr);
      if (stop.stop_requested()) return;
      call_(work_, 1);
      hand(nullptr);
    }
  }

  void (*call_)(const void*, int) = nullptr;
  std::atomic<const void*> work_ = nullptr;
  std::jthread other_;
};

} // namespace bench
