#include <kanexpr/ensemble/stop_on_signal.hpp>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>

namespace {

using kanexpr::stop_on_signal;

bool is_asked(const stop_on_signal& stop) {
  for (int i = 0; i < 5000 && !stop.token().stop_requested(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return stop.token().stop_requested();
}

TEST(stop_on_signal, asks_and_does_not_end_the_program) {
  const stop_on_signal stop;
  EXPECT_FALSE(stop.token().stop_requested());
  std::raise(SIGTERM);
  EXPECT_TRUE(is_asked(stop));
  std::raise(SIGINT);
}

TEST(stop_on_signal, listens_to_other_signals_again_when_one_within_is_gone) {
  const stop_on_signal stop({SIGUSR1});
  {
    const stop_on_signal within({SIGUSR1});
    std::raise(SIGUSR1);
    EXPECT_TRUE(is_asked(within));
  }
  EXPECT_FALSE(stop.token().stop_requested());
  std::raise(SIGUSR1);
  EXPECT_TRUE(is_asked(stop));
}

TEST(stop_on_signal_death_test, lets_the_program_end_afterwards) {
  {
    const stop_on_signal stop;
  }
  EXPECT_EXIT(std::raise(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

} // namespace
