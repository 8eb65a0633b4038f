#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>

#include <csignal>
#include <initializer_list>
#include <stop_token>

namespace kanexpr {

/// Asks a study to end where this process is sent a signal, as by Ctrl-C or by a scheduler whose time is up:
///
///     const stop_on_signal stop;
///     study.run({.checkpoint = "study.note", .stop = stop.token()});
///
/// Runs that have begun are completed, and all that was done is kept. As long as the object lives, these
/// signals do not end the program. Several may live at once, on any threads, and end in any order: a signal
/// asks all of them that listen to it.
class stop_on_signal {
public:
  KANEXPR_ENSEMBLES explicit stop_on_signal(std::initializer_list<int> which = {SIGINT, SIGTERM, SIGUSR1});
  stop_on_signal(const stop_on_signal&) = delete;
  stop_on_signal& operator=(const stop_on_signal&) = delete;
  KANEXPR_ENSEMBLES ~stop_on_signal();

  std::stop_token token() const { return source_.get_token(); }

private:
  std::stop_source source_{};
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/stop_on_signal.hpp>
#endif
