#pragma once

#include <kanexpr/ensemble/stop_on_signal.hpp>

#include <atomic>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace kanexpr {

namespace ensembles {

/// Where a signal is told, as its handler may do hardly anything but write.
inline std::atomic<int> told_of_signals{-1};

inline void tell_of_signal(int) {
  const int before = errno;
  const char any = 1;
  // A pipe that is full has told of it already.
  [[maybe_unused]] const auto count = ::write(told_of_signals.load(), &any, 1);
  errno = before;
}

} // namespace ensembles

KANEXPR_ENSEMBLES stop_on_signal::stop_on_signal(std::initializer_list<int> which) {
  if (::pipe2(ends_, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "signals cannot be listened to");
  ::fcntl(ends_[1], F_SETFL, O_NONBLOCK);
  listens_ = std::thread([from = ends_[0], source = source_]() mutable {
    char any = 0;
    ::ssize_t count = 0;
    while ((count = ::read(from, &any, 1)) < 0 && errno == EINTR) {
    }
    if (count > 0) source.request_stop();
  });
  written_to_before_ = ensembles::told_of_signals.exchange(ends_[1]);
  struct sigaction told = {};
  told.sa_handler = ensembles::tell_of_signal;
  told.sa_flags = SA_RESTART;
  ::sigemptyset(&told.sa_mask);
  for (const int each : which) {
    struct sigaction before = {};
    if (::sigaction(each, &told, &before) == 0) before_.emplace_back(each, before);
  }
}

KANEXPR_ENSEMBLES stop_on_signal::~stop_on_signal() {
  for (const auto& [signal, did] : before_) ::sigaction(signal, &did, nullptr);
  ensembles::told_of_signals = written_to_before_;
  ::close(ends_[1]); // ends who reads
  listens_.join();
  ::close(ends_[0]);
}

} // namespace kanexpr
