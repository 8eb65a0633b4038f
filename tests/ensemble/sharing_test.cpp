#include <kanexpr/ensemble/sharing.hpp>

#include <gmock/gmock.h>

#include <memory>
#include <numeric>
#include <random>
#include <thread>

namespace {

using kanexpr::finished_run;
using kanexpr::ensembles::share;
using kanexpr::ensembles::sharing;

std::vector<finished_run> done(const share& one) {
  std::vector<finished_run> runs(one.count);
  for (std::size_t i = 0; i < one.count; ++i) runs[i].run = one.first + i;
  return runs;
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

struct taken {
  std::vector<std::size_t> runs;
  std::size_t most = 1'000'000;
  sharing::taker taker() {
    return [this](std::vector<finished_run>&& some) {
      for (const finished_run& each : some) runs.push_back(each.run);
      return runs.size() < most;
    };
  }
};

TEST(sharing, hands_on_in_order_what_threads_finish_in_any) {
  for (const std::size_t side_by_side : {1u, 8u}) {
    taken all;
    sharing shares({.runs = 2001, .side_by_side = side_by_side, .takers = 8, .most_ahead = 64}, {},
                   all.taker());
    {
      std::vector<std::jthread> threads;
      for (unsigned seed = 0; seed < 8; ++seed)
        threads.emplace_back([&shares, seed, side_by_side] {
          std::mt19937 random(seed);
          while (const auto one = shares.next()) {
            EXPECT_EQ(one->first % side_by_side, 0u);
            if (random() % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            shares.finish(*one, done(*one));
          }
        });
    }
    EXPECT_TRUE(shares.is_over());
    EXPECT_EQ(all.runs, first(2001));
  }
}

TEST(sharing, goes_on_behind_what_was_done) {
  taken all;
  sharing shares({.runs = 10, .done = 7}, {}, all.taker());
  while (const auto one = shares.next()) shares.finish(*one, done(*one));
  EXPECT_THAT(all.runs, testing::ElementsAre(7, 8, 9));
}

TEST(sharing, does_not_run_too_far_ahead_of_the_slowest) {
  taken all;
  sharing shares({.runs = 100, .most_ahead = 4}, {}, all.taker());
  const auto slow = shares.next_at_once();
  for (int i = 0; i < 3; ++i) {
    const auto one = shares.next_at_once();
    ASSERT_TRUE(one);
    shares.finish(*one, done(*one));
  }
  EXPECT_FALSE(shares.next_at_once());
  EXPECT_FALSE(shares.is_over());
  EXPECT_TRUE(all.runs.empty());
  shares.finish(*slow, done(*slow));
  EXPECT_EQ(all.runs, first(4));
  EXPECT_TRUE(shares.next_at_once());
}

TEST(sharing, ends_with_the_first_runs_where_it_is_stopped) {
  const auto stop = std::make_shared<std::stop_source>(); // g++ 12 takes one on the stack for uninitialized
  taken all;
  sharing shares({.runs = 100}, stop->get_token(), all.taker());
  const auto slow = shares.next(), other = shares.next();
  shares.finish(*other, done(*other));
  stop->request_stop();
  EXPECT_FALSE(shares.next());
  EXPECT_FALSE(shares.is_over());
  shares.finish(*slow, done(*slow));
  EXPECT_TRUE(shares.is_over());
  EXPECT_EQ(all.runs, first(2));
}

TEST(sharing, ends_where_no_more_are_wanted) {
  taken all{{}, 3};
  sharing shares({.runs = 100}, {}, all.taker());
  while (const auto one = shares.next()) shares.finish(*one, done(*one));
  EXPECT_GE(all.runs.size(), 3u);
  EXPECT_LT(all.runs.size(), 100u);
}

TEST(sharing, gives_out_once_more_what_is_overdue) {
  taken all;
  sharing shares({.runs = 2}, {}, all.taker());
  const auto lost = shares.next(), quick = shares.next();
  shares.finish(*quick, done(*quick));
  EXPECT_FALSE(shares.overdue(1000));
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const auto again = shares.overdue(0.001);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->first, lost->first);
  EXPECT_EQ(again->count, lost->count);
  shares.finish(*again, done(*again));
  EXPECT_EQ(all.runs, first(2));
  shares.finish(*lost, done(*lost)); // who was taken for lost was only slow
  EXPECT_EQ(all.runs, first(2));
  EXPECT_TRUE(shares.is_over());
}

TEST(sharing, gives_larger_shares_of_short_runs) {
  taken all;
  sharing shares({.runs = 100'000, .seconds_of_share = 10}, {}, all.taker());
  std::size_t count = 0;
  while (const auto one = shares.next()) {
    ++count;
    shares.finish(*one, done(*one));
  }
  EXPECT_EQ(all.runs, first(100'000));
  EXPECT_LT(count, 1000u);
}

} // namespace
