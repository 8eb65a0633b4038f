#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>

namespace kanexpr {

namespace ensembles {

/// The number of times each signal was received. A signal handler may do little more than count.
inline std::array<std::atomic<unsigned>, 128> signals_received{};

/// Installs the handler of a signal while at least one object listens to it.
inline void listen_to(int signal, bool begins) {
  struct handled {
    int listeners = 0;
    struct sigaction before = {};
  };
  static std::mutex mutex;
  static std::map<int, handled> all;
  const std::scoped_lock lock(mutex);
  handled& one = all[signal];
  struct sigaction counts = {};
  counts.sa_handler = [](int received) { ++signals_received[static_cast<std::size_t>(received)]; };
  counts.sa_flags = SA_RESTART;
  if (begins && one.listeners++ == 0) ::sigaction(signal, &counts, &one.before);
  if (!begins && --one.listeners == 0) ::sigaction(signal, &one.before, nullptr);
}

} // namespace ensembles

/// Stops a study when this process receives a signal, for example from Ctrl-C or a batch scheduler:
///
///     const stop_on_signal stop;
///     study.run({.checkpoint = "study.checkpoint", .stop = stop.token()});
///
/// Runs that have started are completed. While the object exists, the signals that it handles do not end the
/// program. Several objects may exist, on any threads, and may be destroyed in any order; a signal stops the
/// studies of all objects that listen to it.
class stop_on_signal {
public:
  explicit stop_on_signal(std::initializer_list<int> watched = {SIGINT, SIGTERM, SIGUSR1}) {
    for (const int each : watched) {
      before_.emplace(each, received(each));
      ensembles::listen_to(each, true);
    }
    thread_ = std::jthread([this](const std::stop_token& ended) { poll(ended); });
  }
  stop_on_signal(const stop_on_signal&) = delete;
  stop_on_signal& operator=(const stop_on_signal&) = delete;
  ~stop_on_signal() {
    for (const auto& [each, count] : before_) ensembles::listen_to(each, false);
  }

  std::stop_token token() const { return source_.get_token(); }

private:
  static unsigned received(int signal) {
    return ensembles::signals_received[static_cast<std::size_t>(signal)];
  }

  void poll(const std::stop_token& ended) {
    std::mutex mutex;
    std::condition_variable_any any;
    for (std::unique_lock lock(mutex); !ended.stop_requested();) {
      for (const auto& [each, count] : before_)
        if (received(each) != count) source_.request_stop();
      any.wait_for(lock, ended, std::chrono::milliseconds(5), [] { return false; });
    }
  }

  std::stop_source source_{};
  std::map<int, unsigned> before_{};
  std::jthread thread_{}; ///< compares the counts with the initial ones
};

} // namespace kanexpr
