#pragma once

#include <kanexpr/ensemble/stop_on_signal.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace kanexpr {

namespace ensembles {

/// What the handler of signals sees, as it may do hardly anything but write.
inline std::atomic<std::uint64_t> signals_sent{0}; ///< a bit of each, until somebody is told
inline std::atomic<int> told_of_signals{-1};       ///< where it writes
inline std::atomic<int> handlers_at_work{0};

inline std::uint64_t bit_of(int signal) { return std::uint64_t{1} << static_cast<unsigned>(signal - 1) % 64; }

inline void tell_of_signal(int signal) {
  const int before = errno;
  ++handlers_at_work;
  signals_sent |= bit_of(signal);
  const char any = 1;
  // A pipe that is full has told of it already.
  const int to = told_of_signals;
  [[maybe_unused]] const auto count = to < 0 ? 0 : ::write(to, &any, 1);
  --handlers_at_work;
  errno = before;
}

/// The one of this process that hears signals and asks those who listen. It reads as long as there are any.
class signal_listener {
public:
  /// It is never gone, as a program may end while some listen.
  static signal_listener& only() {
    static signal_listener& one = *new signal_listener;
    return one;
  }

  void add(const std::stop_source& asks, std::initializer_list<int> which) {
    ask(); // for what was sent before is not for this one
    const std::scoped_lock changing(changes_);
    if (!reads_.joinable()) begin();
    {
      const std::scoped_lock lock(list_);
      listening_.push_back({asks, which});
    }
    struct sigaction told = {};
    told.sa_handler = tell_of_signal;
    told.sa_flags = SA_RESTART;
    ::sigemptyset(&told.sa_mask);
    for (const int each : which) {
      struct sigaction before = {};
      if (!before_.contains(each) && ::sigaction(each, &told, &before) == 0) before_.emplace(each, before);
    }
  }

  void remove(const std::stop_source& asks) {
    ask();
    const std::scoped_lock changing(changes_);
    {
      const std::scoped_lock lock(list_);
      std::erase_if(listening_, [&](const listening& each) { return each.asks == asks; });
    }
    std::erase_if(before_, [&](const auto& each) {
      const int signal = each.first;
      if (std::ranges::any_of(listening_, [&](const listening& one) { return one.hears(signal); }))
        return false;
      ::sigaction(signal, &each.second, nullptr);
      return true;
    });
    if (listening_.empty()) end();
  }

private:
  struct listening {
    std::stop_source asks;
    std::vector<int> which;
    bool hears(int signal) const { return std::ranges::find(which, signal) != which.end(); }
  };

  signal_listener() = default;

  void begin() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "signals cannot be listened to");
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    try {
      reads_ = std::thread([this, from = ends[0]] { read(from); });
    } catch (...) {
      ::close(ends[0]), ::close(ends[1]);
      throw;
    }
    from_ = ends[0];
    told_of_signals = ends[1];
  }

  void end() {
    const int to = told_of_signals.exchange(-1);
    while (handlers_at_work > 0) std::this_thread::yield(); // else they would write to what is opened next
    ::close(to);                                            // ends who reads
    reads_.join();
    ::close(from_);
  }

  void read(int from) {
    char any = 0;
    ::ssize_t count = 0;
    while ((count = ::read(from, &any, 1)) > 0 || (count < 0 && errno == EINTR))
      if (count > 0) ask();
  }

  void ask() {
    std::vector<std::stop_source> asked;
    {
      const std::scoped_lock lock(list_);
      const std::uint64_t sent = signals_sent.exchange(0);
      for (const listening& each : listening_)
        if (std::ranges::any_of(each.which, [&](int one) { return (sent & bit_of(one)) != 0; }))
          asked.push_back(each.asks);
    }
    for (std::stop_source& each : asked) each.request_stop();
  }

  std::mutex changes_{}, list_{};            ///< the second for the list alone, which is read meanwhile
  std::vector<listening> listening_{};       ///< changed under both
  std::map<int, struct sigaction> before_{}; ///< what each signal did
  std::thread reads_{};
  int from_ = -1;
};

} // namespace ensembles

KANEXPR_ENSEMBLES stop_on_signal::stop_on_signal(std::initializer_list<int> which) {
  ensembles::signal_listener::only().add(source_, which);
}

KANEXPR_ENSEMBLES stop_on_signal::~stop_on_signal() { ensembles::signal_listener::only().remove(source_); }

} // namespace kanexpr
