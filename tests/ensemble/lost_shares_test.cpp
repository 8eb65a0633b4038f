#include <kanexpr/ensemble/sharing.hpp>

#include <gmock/gmock.h>

#include <numeric>

namespace {

using namespace kanexpr;
using ensembles::share;
using ensembles::sharing;

std::vector<finished_run> left_by(const share& one) {
  std::vector<finished_run> all(one.count);
  for (std::size_t i = 0; i < one.count; ++i) all[i].run = one.first + i;
  return all;
}

/// Shares of runs of which three are done side by side, and what came of them in their order.
struct lost_shares : testing::Test {
  std::vector<std::size_t> taken{};
  sharing shares{{.runs = 40, .done = 1, .side_by_side = 3, .seconds_of_share = 1000},
                 {},
                 [this](std::vector<finished_run>&& runs) {
                   for (const finished_run& each : runs) taken.push_back(each.run);
                   return true;
                 }};

  std::optional<share> lost() { return shares.overdue(1000); }
};

MATCHER_P2(is_share, first, count, "") {
  return arg && arg->first == std::size_t{first} && arg->count == std::size_t{count};
}

TEST_F(lost_shares, are_given_out_again_in_parts_that_begin_as_shares_do) {
  const share before = *shares.next(); // until it is known how long runs take, those side by side
  shares.finish(before, left_by(before), 1e-9);
  const share whole = *shares.next();
  EXPECT_EQ(whole.first, 3u);
  ASSERT_GE(whole.count, 6u);
  EXPECT_FALSE(lost());
  shares.lose(whole);
  const auto first = lost();
  EXPECT_THAT(first, is_share(3u, 3u));
  EXPECT_THAT(lost(), is_share(6u, 3u));
  shares.finish(*first, left_by(*first));
  shares.finish(*first, left_by(*first)); // as another one has meanwhile
  EXPECT_THAT(taken, testing::ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(lost_shares, are_taken_from_who_was_only_slow) {
  const share before = *shares.next();
  shares.finish(before, left_by(before), 1e-9);
  const share whole = *shares.next();
  shares.lose(whole);
  const auto part = lost();
  shares.finish(*part, left_by(*part));
  shares.finish(whole, left_by(whole));
  EXPECT_FALSE(lost());
  while (const auto one = shares.next()) shares.finish(*one, left_by(*one));
  EXPECT_TRUE(shares.is_over());
  std::vector<std::size_t> all(39);
  std::iota(all.begin(), all.end(), 1);
  EXPECT_EQ(taken, all);
}

TEST_F(lost_shares, are_tried_for_the_last_time_one_after_another) {
  const share one = *shares.next(), other = *shares.next();
  shares.lose(one), shares.lose(other);
  EXPECT_THAT(lost(), is_share(one.first, one.count));
  EXPECT_THAT(lost(), is_share(other.first, other.count));
  shares.lose(one), shares.lose(other);
  EXPECT_THAT(lost(), is_share(one.first, one.count));
  EXPECT_FALSE(lost());
  EXPECT_FALSE(shares.hopeless(1000));
  shares.lose(one);
  EXPECT_FALSE(lost());
  const auto hopeless = shares.hopeless(1000);
  EXPECT_THAT(hopeless, is_share(one.first, one.count));
  shares.finish(*hopeless, left_by(*hopeless));
  EXPECT_THAT(lost(), is_share(other.first, other.count));
  shares.finish(other, left_by(other));
  EXPECT_THAT(taken, testing::ElementsAre(1, 2, 3, 4, 5));
}

} // namespace
