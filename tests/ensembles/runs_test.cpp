// builds: clang++
#include <kanexpr/ensembles/random_stream.hpp>
#include <kanexpr/ensembles/runs.hpp>

#include <gmock/gmock.h>

#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/weibull.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace {

using namespace kanexpr;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::SizeIs;

std::vector<double> values_of(const runs& all, std::size_t column) {
  std::vector<double> values;
  for (std::size_t i = 0; i < all.size(); ++i) values.push_back(run_values(all, i).all()[column]);
  return values;
}

TEST(runs, are_one_where_nothing_differs) {
  EXPECT_EQ(runs().size(), 1u);
  EXPECT_THAT(run_values(runs(), 0).all(), SizeIs(0));
}

TEST(runs, of_a_grid_are_all_combinations) {
  const runs all = grid({{"a", {1, 2}}, {"b", evenly_spaced(0, 1, 3)}});
  ASSERT_EQ(all.size(), 6u);
  EXPECT_THAT(values_of(all, 0), ElementsAre(1, 1, 1, 2, 2, 2));
  EXPECT_THAT(values_of(all, 1), ElementsAre(0, 0.5, 1, 0, 0.5, 1));
  EXPECT_EQ(run_values(all, 4)["b"], 0.5);
  EXPECT_THROW(run_values(all, 4)["c"], std::out_of_range);
}

TEST(runs, of_a_grid_end_where_they_were_told_to) {
  EXPECT_EQ(evenly_spaced(0.1, 0.7, 1000).back(), 0.7);
  EXPECT_THAT(evenly_spaced(3, 4, 1), ElementsAre(3));
  EXPECT_THAT(evenly_spaced(3, 4, 0), SizeIs(0));
}

TEST(runs, of_a_table_are_its_rows) {
  table given;
  ASSERT_TRUE(given.add("m", {1, 2, 3}));
  ASSERT_TRUE(given.add("push", {4, 5, 6}));
  const runs all = runs_of(given, {{"push"}});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_FALSE(all.varied()[0].is_factor());
  EXPECT_TRUE(all.varied()[1].is_factor());
  EXPECT_EQ(run_values(all, 2)[factor{"push"}], 6);
}

// The test vectors in Random123's file kat_vectors.
TEST(philox, has_the_published_vectors) {
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_THAT(ensembles::philox({0, 0, 0, 0}, {0, 0}),
              ElementsAre(0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8));
  EXPECT_THAT(ensembles::philox({ones, ones, ones, ones}, {ones, ones}),
              ElementsAre(0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd));
  EXPECT_THAT(ensembles::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              ElementsAre(0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1));
}

TEST(content_hash, has_the_published_values) {
  EXPECT_EQ(content_hash(""), 0xcbf29ce484222325u);
  EXPECT_EQ(content_hash("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(content_hash("foobar"), 0x85944171f73967e8u);
}

// The numbers of a study must be the same on every machine and in all later versions.
TEST(runs, at_random_are_the_same_everywhere) {
  const runs all = random_runs(3, {{"a", uniform(0, 1)}}, 42);
  EXPECT_THAT(values_of(all, 0), ElementsAre(DoubleEq(0.095405772447758053), DoubleEq(0.91850643705341428),
                                             DoubleEq(0.65499161504890557)));
  const runs more = random_runs(5, {{"b", uniform(0, 1)}, {"a", uniform(0, 1)}}, 42);
  EXPECT_EQ(values_of(more, 1)[2], values_of(all, 0)[2]);
  EXPECT_NE(values_of(more, 0)[2], values_of(all, 0)[2]);
  EXPECT_NE(values_of(random_runs(3, {{"a", uniform(0, 1)}}, 43), 0)[0], values_of(all, 0)[0]);
}

TEST(runs, at_random_have_the_moments_of_their_distributions) {
  constexpr std::size_t n = 200'000;
  const runs all = random_runs(n, {{"a", normal(3, 2)}, {"b", uniform(-1, 1)}}, 7);
  const std::vector<double> a = values_of(all, 0), b = values_of(all, 1);
  double mean = 0, square = 0, cube = 0, fourth = 0, product = 0, neighbours = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = (a[i] - 3) / 2;
    mean += z / n, square += z * z / n, cube += z * z * z / n, fourth += z * z * z * z / n;
    product += z * b[i] / n;
    if (i > 0) neighbours += z * (a[i - 1] - 3) / 2 / n;
  }
  // Tolerances: five standard deviations of these sums.
  EXPECT_NEAR(mean, 0, 5 * std::sqrt(1.0 / n));
  EXPECT_NEAR(square, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(cube, 0, 5 * std::sqrt(15.0 / n));
  EXPECT_NEAR(fourth, 3, 5 * std::sqrt(96.0 / n));
  EXPECT_NEAR(product, 0, 5 * std::sqrt(1 / 3.0 / n));
  EXPECT_NEAR(neighbours, 0, 5 * std::sqrt(1.0 / n));
}

TEST(runs, of_a_latin_hypercube_draw_once_from_each_range) {
  for (const std::size_t n : {1u, 2u, 3u, 10u, 1000u, 4097u}) {
    const runs all = latin_hypercube(n, {{"a", uniform(0, 1)}, {"b", uniform(0, 1)}}, 5);
    for (const std::size_t column : {0u, 1u}) {
      std::set<std::size_t> ranges;
      for (double each : values_of(all, column)) ranges.insert(static_cast<std::size_t>(each * double(n)));
      EXPECT_EQ(ranges.size(), n);
      EXPECT_LT(*ranges.rbegin(), n);
    }
  }
}

TEST(runs, of_a_latin_hypercube_do_not_go_together) {
  const runs all = latin_hypercube(1000, {{"a", uniform(0, 1)}, {"b", uniform(0, 1)}}, 5);
  const std::vector<double> a = values_of(all, 0), b = values_of(all, 1);
  double product = 0;
  for (std::size_t i = 0; i < 1000; ++i) product += 12 * (a[i] - 0.5) * (b[i] - 0.5) / 1000;
  EXPECT_NEAR(product, 0, 5 / std::sqrt(1000.0));
}

TEST(runs, in_a_random_order_are_each_there_once) {
  for (std::uint64_t size = 1; size < 300; ++size) {
    const ensembles::permutation order(ensembles::random_stream(size, "order"), size);
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < size; ++i) seen.insert(order(i));
    EXPECT_EQ(seen.size(), size);
    EXPECT_LT(*seen.rbegin(), size);
  }
  const ensembles::permutation large(ensembles::random_stream(1, "order"), 1'000'000'007);
  EXPECT_LT(large(999'999'999), 1'000'000'007u);
}

TEST(distributions, have_their_quantiles) {
  EXPECT_THAT(normal(1, 2).quantile(0.5), DoubleEq(1));
  EXPECT_NEAR(normal(1, 2).quantile(0.841344746068543), 3, 1e-12);
  EXPECT_NEAR(log_uniform(1e-3, 10).quantile(0.75), 1, 1e-14);
  const boost::math::triangular_distribution<> reference(1, 1.5, 4);
  for (double part : {0.01, 0.1, 1.0 / 6, 0.3, 0.9})
    EXPECT_NEAR(triangular(1, 1.5, 4).quantile(part), quantile(reference, part), 1e-14);
  const auto cut = truncated_normal(0, 1, -1, 2);
  EXPECT_NEAR(cut.quantile(1e-300), -1, 1e-12);
  EXPECT_NEAR(cut.quantile(1 - 0x1p-53), 2, 1e-12);
  const boost::math::weibull_distribution<> life(1.5, 2);
  const distribution own("weibull(1.5, 2)", [life](double part) { return quantile(life, part); });
  EXPECT_EQ(own.quantile(0.3), quantile(life, 0.3));
}

TEST(distributions, cut_far_out_are_as_exact_as_within) {
  const auto above = [](double z) { return std::erfc(z / std::sqrt(2.0)) / 2; };
  for (const auto& [from, to] : {std::pair{5.0, 6.0}, {8.2, 8.3}, {9.0, 10.0}, {37.0, 38.0}}) {
    const auto cut = truncated_normal(0, 1, from, to), mirrored = truncated_normal(0, 1, -to, -from);
    ASSERT_EQ(cut.mistake() + mirrored.mistake(), "");
    for (double part : {0x1p-53, 0.001, 0.25, 0.5, 0.75, 1 - 0x1p-53}) {
      const double z = cut.quantile(part);
      EXPECT_NEAR((above(from) - above(z)) / (above(from) - above(to)), part, 1e-11) << from;
      EXPECT_NEAR(mirrored.quantile(1 - part), -z, 1e-13 * to);
      EXPECT_GE(z, from);
      EXPECT_LE(z, to);
    }
  }
  const auto positive = truncated_normal(1, 0.2, 0, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(positive.quantile(0.5), 1 + 0.2 * std::sqrt(2 * std::acos(-1.0)) * above(5) / 2, 1e-12);
  EXPECT_TRUE(std::isfinite(positive.quantile(1)));
}

TEST(distributions, over_more_than_numbers_can_say_are_right) {
  EXPECT_NEAR(uniform(-1.5e308, 1.5e308).quantile(0.75), 0.75e308, 1e293);
  EXPECT_NEAR(std::log10(log_uniform(1e-300, 1e300).quantile(0.75)), 150, 1e-12);
  EXPECT_NEAR(triangular(-1e308, 0, 1e308).quantile(0.125), -0.5e308, 1e293);
  EXPECT_NEAR(triangular(-1e308, 0, 1e308).quantile(0.875), 0.5e308, 1e293);
  EXPECT_THAT(evenly_spaced(-1.6e308, 1.6e308, 5),
              ElementsAre(-1.6e308, DoubleEq(-0.8e308), 0, DoubleEq(0.8e308), 1.6e308));
  EXPECT_EQ(normal(0, 1e308).mistake(), "invalid distribution normal(0, 1e+308): its draws must be finite");
}

// Whether or not the compiler contracts into fused multiply-adds, the result is rounded once.
TEST(distributions, have_the_same_bits_everywhere) {
  EXPECT_EQ(uniform(-3.1, 2.7).quantile(0.35), -1.07);
  EXPECT_EQ(evenly_spaced(-3.1, 2.7, 21)[7], -1.07);
}

TEST(distributions, are_told_with_all_digits) {
  EXPECT_EQ(uniform(0, 0.25).identity(), "uniform(0, 0.25)");
  EXPECT_NE(uniform(0, 1).identity(), uniform(0, std::nextafter(1, 2)).identity());
}

TEST(runs, that_cannot_be_say_why) {
  const auto mistake_of = [](const runs& all) { return all.mistake(); };
  EXPECT_EQ(mistake_of(random_runs(9, {{"m", normal(1, -1)}}, 1)),
            "invalid distribution normal(1, -1): the deviation must be positive");
  EXPECT_EQ(mistake_of(random_runs(9, {{"m", uniform(2, 1)}}, 1)),
            "invalid distribution uniform(2, 1): its start must be below its end");
  EXPECT_EQ(mistake_of(random_runs(9, {{"m", log_uniform(0, 1)}}, 1)),
            "invalid distribution log_uniform(0, 1): its start must be above 0 and below its end");
  EXPECT_EQ(mistake_of(random_runs(9, {{"m", truncated_normal(0, 1, 50, 60)}}, 1)),
            "invalid distribution truncated_normal(0, 1, 50, 60): the deviation must be positive, and the "
            "probability between the bounds must not vanish");
  EXPECT_EQ(mistake_of(random_runs(9, {{"m", triangular(0, 2, 1)}}, 1)),
            "invalid distribution triangular(0, 2, 1): its mode must lie between its ends");
  EXPECT_EQ(mistake_of(latin_hypercube(0, {{"m", uniform(0, 1)}}, 1)), "a study requires at least one run");
  EXPECT_EQ(mistake_of(grid({{"m", {}}})), "the grid has no values for m");
  EXPECT_EQ(mistake_of(grid({{"m", {1}}, {"m", {2}}})), "m is varied twice");
  EXPECT_EQ(mistake_of(grid({{"", {1}}})), "a varied quantity has no name");
  const std::vector<double> many(1 << 16);
  EXPECT_EQ(mistake_of(grid({{"a", many}, {"b", many}, {"c", many}, {"d", many}})),
            "the grid has more than 2^53 runs");
  const std::size_t most = std::size_t{1} << 53;
  EXPECT_EQ(mistake_of(random_runs(most, {{"m", uniform(0, 1)}}, 1)), "");
  EXPECT_EQ(mistake_of(random_runs(most + 1, {{"m", uniform(0, 1)}}, 1)),
            "random_runs has more than 2^53 runs");
  EXPECT_EQ(mistake_of(latin_hypercube(most + 1, {{"m", uniform(0, 1)}}, 1)),
            "latin_hypercube has more than 2^53 runs");
  EXPECT_EQ(mistake_of(runs_of({})), "the table of runs has no rows");
  table one;
  ASSERT_TRUE(one.add("m", {1}));
  EXPECT_EQ(mistake_of(runs_of(one, {{"push"}})), "the table of runs has no column push");
}

} // namespace
