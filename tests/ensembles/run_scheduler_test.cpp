// builds: clang++
#include <kanexpr/ensembles/run_scheduler.ipp>

#include <gmock/gmock.h>

#include <memory>
#include <numeric>
#include <random>
#include <thread>

namespace {

using kanexpr::finished_run;
using kanexpr::ensembles::finished_share;
using kanexpr::ensembles::run_scheduler;
using kanexpr::ensembles::share;

finished_share done(const share& one) {
  std::vector<finished_run> runs(one.count);
  for (std::size_t i = 0; i < one.count; ++i) runs[i].run = one.first + i;
  return {one.first, std::move(runs), 1e-9};
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

struct taken {
  std::vector<std::size_t> runs;
  std::size_t most = 1'000'000;
  run_scheduler::consumer consumer() {
    return [this](std::vector<finished_run>&& some) {
      for (const finished_run& each : some) runs.push_back(each.run);
      return runs.size() < most;
    };
  }
};

TEST(run_scheduler, passes_on_in_order_what_threads_finish_in_any_order) {
  for (const std::size_t lanes : {1u, 8u}) {
    taken all;
    run_scheduler shares({.runs = 2001, .lanes = lanes, .workers = 8, .max_pending = 64}, {}, all.consumer());
    {
      std::vector<std::jthread> threads;
      for (unsigned seed = 0; seed < 8; ++seed)
        threads.emplace_back([&shares, seed, lanes] {
          std::mt19937 random(seed);
          for (share one = shares.next(); one.count > 0; one = shares.next()) {
            EXPECT_EQ(one.first % lanes, 0u);
            if (random() % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            shares.finish(done(one));
          }
        });
    }
    EXPECT_TRUE(shares.is_over());
    EXPECT_EQ(all.runs, first(2001));
  }
}

TEST(run_scheduler, resumes_after_the_runs_that_are_done) {
  taken all;
  run_scheduler shares({.runs = 10, .done = 7}, {}, all.consumer());
  for (share one = shares.next(); one.count > 0; one = shares.next()) shares.finish(done(one));
  EXPECT_THAT(all.runs, testing::ElementsAre(7, 8, 9));
}

TEST(run_scheduler, limits_the_runs_pending_behind_a_slow_one) {
  taken all;
  run_scheduler shares({.runs = 100, .max_pending = 4}, {}, all.consumer());
  const auto slow = shares.try_next();
  for (int i = 0; i < 3; ++i) {
    const auto one = shares.try_next();
    ASSERT_TRUE(one);
    shares.finish(done(*one));
  }
  EXPECT_FALSE(shares.try_next());
  EXPECT_FALSE(shares.is_over());
  EXPECT_TRUE(all.runs.empty());
  shares.finish(done(*slow));
  EXPECT_EQ(all.runs, first(4));
  EXPECT_TRUE(shares.try_next());
}

TEST(run_scheduler, ends_without_gaps_after_a_stop_request) {
  const auto stop = std::make_shared<std::stop_source>(); // g++ 12 reports one on the stack as uninitialized
  taken all;
  run_scheduler shares({.runs = 100}, stop->get_token(), all.consumer());
  const auto slow = shares.next(), other = shares.next();
  shares.finish(done(other));
  stop->request_stop();
  EXPECT_EQ(shares.next().count, 0u);
  EXPECT_FALSE(shares.is_over());
  shares.finish(done(slow));
  EXPECT_TRUE(shares.is_over());
  EXPECT_EQ(all.runs, first(2));
}

TEST(run_scheduler, ends_when_the_consumer_needs_no_more) {
  taken all{{}, 3};
  run_scheduler shares({.runs = 100}, {}, all.consumer());
  for (share one = shares.next(); one.count > 0; one = shares.next()) shares.finish(done(one));
  EXPECT_GE(all.runs.size(), 3u);
  EXPECT_LT(all.runs.size(), 100u);
}

TEST(run_scheduler, gives_larger_shares_of_short_runs) {
  taken all;
  run_scheduler shares({.runs = 100'000, .share_seconds = 10}, {}, all.consumer());
  std::size_t count = 0;
  for (share one = shares.next(); one.count > 0; one = shares.next()) {
    ++count;
    shares.finish(done(one));
  }
  EXPECT_EQ(all.runs, first(100'000));
  EXPECT_LT(count, 1000u);
}

} // namespace
