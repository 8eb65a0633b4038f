// builds: clang++
#include <kanexpr/ensembles/stop_on_signal.hpp>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>

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

TEST(stop_on_signal, asks_all_that_listen_to_the_signal) {
  const stop_on_signal stop({SIGUSR1}), other({SIGUSR2});
  {
    const stop_on_signal within({SIGUSR1, SIGTERM});
    std::raise(SIGUSR1);
    EXPECT_TRUE(is_asked(within));
    EXPECT_TRUE(is_asked(stop));
    const stop_on_signal late({SIGUSR1});
    EXPECT_FALSE(late.token().stop_requested()); // signals sent earlier do not count
  }
  EXPECT_FALSE(other.token().stop_requested());
  std::raise(SIGUSR2);
  EXPECT_TRUE(is_asked(other));
}

int heard = 0;

TEST(stop_on_signal, objects_may_end_in_any_order) {
  struct sigaction mine = {}, before = {};
  mine.sa_handler = [](int) { ++heard; };
  ASSERT_EQ(::sigaction(SIGUSR1, &mine, &before), 0);
  auto first = std::make_unique<stop_on_signal>();
  auto second = std::make_unique<stop_on_signal>();
  std::thread([&] { first.reset(); }).join();
  std::raise(SIGUSR1);
  EXPECT_TRUE(is_asked(*second));
  EXPECT_EQ(heard, 0);
  second.reset();

  std::FILE* since[8] = {}; // reuse their file descriptors
  for (std::FILE*& each : since) each = std::tmpfile();
  std::raise(SIGUSR1);
  EXPECT_EQ(heard, 1);
  for (std::FILE* each : since) {
    std::fseek(each, 0, SEEK_END);
    EXPECT_EQ(std::ftell(each), 0);
    std::fclose(each);
  }
  ::sigaction(SIGUSR1, &before, nullptr);
}

TEST(stop_on_signal, objects_come_and_go_while_signals_are_sent) {
  const stop_on_signal all;
  const auto come_and_go = [] {
    for (int i = 0; i < 200; ++i) {
      const stop_on_signal one({SIGUSR2});
      std::raise(SIGUSR2);
      EXPECT_TRUE(is_asked(one));
    }
  };
  std::thread other(come_and_go);
  come_and_go();
  other.join();
  EXPECT_FALSE(all.token().stop_requested());
}

TEST(stop_on_signal_death_test, lets_the_program_end_afterwards) {
  {
    const stop_on_signal stop;
  }
  EXPECT_EXIT(std::raise(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

} // namespace
