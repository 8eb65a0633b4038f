#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/reduction.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace kanexpr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<double> draws(std::size_t count) {
  std::mt19937 random(3);
  std::lognormal_distribution<double> from(0, 2);
  std::vector<double> all(count);
  for (double& each : all) each = from(random);
  return all;
}

// Saves and restores a reduction halfway.
template <class Reduction>
Reduction halfway_noted(Reduction one, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < numbers.size() / 2; ++i) one.take(numbers[i]);
  ensembles::saver noted;
  noted(one);
  Reduction other;
  ensembles::loader from(noted.bytes());
  from(other);
  EXPECT_TRUE(from.is_at_end());
  for (std::size_t i = numbers.size() / 2; i < numbers.size(); ++i) other.take(numbers[i]);
  return other;
}

TEST(statistics, are_those_of_all_numbers) {
  std::vector<double> numbers = draws(10'000);
  for (double& each : numbers) each += 1e6; // so that sums of squares would lose six digits
  const statistics found = halfway_noted(statistics(), numbers);
  long double mean = 0, squares = 0;
  for (double each : numbers) mean += each;
  mean /= 10'000;
  for (double each : numbers) squares += (each - mean) * (each - mean);
  EXPECT_EQ(found.count(), 10'000u);
  EXPECT_NEAR(found.mean(), static_cast<double>(mean), 1e-8);
  EXPECT_NEAR(found.variance() / static_cast<double>(squares / 9999), 1, 1e-12);
  EXPECT_DOUBLE_EQ(found.error_of_mean(), found.deviation() / 100);
  EXPECT_EQ(found.least(), *std::ranges::min_element(numbers));
  EXPECT_EQ(found.greatest(), *std::ranges::max_element(numbers));
}

TEST(statistics, of_nothing_are_no_numbers) {
  statistics found;
  found.take(none);
  EXPECT_EQ(found.missing(), 1u);
  EXPECT_TRUE(std::isnan(found.mean()) && std::isnan(found.least()) && std::isnan(found.greatest()));
  found.take(3);
  EXPECT_EQ(found.mean(), 3);
  EXPECT_TRUE(std::isnan(found.variance()));
}

TEST(statistics, of_infinities_and_large_numbers_are_right) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  statistics up, down, both, large;
  for (double each : {infinity, 1.0, 2.0}) up.take(each), down.take(-each);
  for (double each : {-infinity, infinity}) both.take(each);
  for (double each : {1.5e308, -1.5e308, 1.5e308, -1.5e308}) large.take(each);
  EXPECT_EQ(up.mean(), infinity);
  EXPECT_EQ(down.mean(), -infinity);
  EXPECT_TRUE(std::isnan(both.mean()) && std::isnan(up.variance()));
  EXPECT_NEAR(large.mean(), 0, 1e293);
  EXPECT_EQ(large.variance(), infinity);
}

void expect_quantiles_of(std::vector<double> numbers) {
  const quantile_sketch found = halfway_noted(quantile_sketch(), numbers);
  std::ranges::sort(numbers);
  for (double part : {0.0, 0.001, 0.05, 0.25, 0.5, 0.9, 0.999, 1.0}) {
    const double wanted = part * static_cast<double>(numbers.size());
    const double at = found.quantile(part);
    const auto low = std::ranges::lower_bound(numbers, at) - numbers.begin();
    const auto high = std::ranges::upper_bound(numbers, at) - numbers.begin();
    // The smallest weight of a stored number adds to the error.
    const auto error = static_cast<double>(found.rank_error()) + 1;
    EXPECT_LE(static_cast<double>(low), wanted + error) << part;
    EXPECT_GE(static_cast<double>(high), wanted - error) << part;
  }
}

TEST(quantiles, are_exact_for_few_numbers) {
  quantile_sketch few;
  for (double each : {5.0, 1.0, 4.0, 2.0, 3.0, none}) few.take(each);
  EXPECT_EQ(few.missing(), 1u);
  EXPECT_EQ(few.rank_error(), 0u);
  EXPECT_EQ(few.quantile(0), 1);
  EXPECT_EQ(few.quantile(0.5), 3);
  EXPECT_EQ(few.quantile(0.6), 3);
  EXPECT_EQ(few.quantile(0.61), 4);
  EXPECT_EQ(few.quantile(1), 5);
  EXPECT_TRUE(std::isnan(few.quantile(1.1)) && std::isnan(few.quantile(none)));
  EXPECT_TRUE(std::isnan(quantile_sketch().quantile(0.5)));
}

TEST(quantiles, are_exact_up_to_the_room) {
  quantile_sketch all;
  for (std::size_t i = 1; i <= quantile_sketch::room; ++i) all.take(static_cast<double>(i));
  EXPECT_EQ(all.rank_error(), 0u);
  EXPECT_EQ(all.quantile(0.5), quantile_sketch::room / 2);
  all.take(0);
  EXPECT_EQ(all.rank_error(), 1u);
}

TEST(quantiles, of_hundredths_are_the_hundredths) {
  quantile_sketch all;
  for (int i = 1; i <= 100; ++i) all.take(i);
  for (int i = 1; i <= 100; ++i) EXPECT_EQ(all.quantile(i / 100.0), i);
}

TEST(quantiles, are_within_the_rank_that_is_told) {
  constexpr std::size_t count = 500'000;
  std::vector<double> numbers = draws(count);
  expect_quantiles_of(numbers);
  std::ranges::sort(numbers);
  expect_quantiles_of(numbers);
  std::ranges::reverse(numbers);
  expect_quantiles_of(numbers);
  std::ranges::fill(numbers, 7);
  expect_quantiles_of(numbers);
  quantile_sketch all;
  for (double each : numbers) all.take(each);
  EXPECT_LT(static_cast<double>(all.rank_error()), 0.002 * count);
}

TEST(histograms, count_all) {
  histogram found = halfway_noted(histogram(0, 10, 5), {-1, 0, 1.999, 2, 9.999, 10, 11, none, 5, 5});
  EXPECT_EQ(found.bins(), 5u);
  EXPECT_EQ(found.below(), 1u);
  EXPECT_EQ(found.above(), 2u);
  EXPECT_EQ(found.missing(), 1u);
  EXPECT_EQ(found.count(0), 2u);
  EXPECT_EQ(found.count(1), 1u);
  EXPECT_EQ(found.count(2), 2u);
  EXPECT_EQ(found.count(4), 1u);
  EXPECT_EQ(found.edge(1), 2);
  EXPECT_EQ(found.edge(5), 10);
  found.take(std::nextafter(10, 0)); // its fraction of the width rounds to 1
  EXPECT_EQ(found.count(4), 2u);
}

TEST(histograms, count_a_number_where_the_edges_tell) {
  for (const auto& [from, to] :
       {std::pair{0.0, 1.0}, {1.0, 3.0}, {-0.1, 0.7}, {-1.7e308, 1.7e308}, {0.0, 1e-322}})
    for (const std::size_t bins : {1u, 7u, 100u})
      for (std::size_t k = 0; k < bins; ++k) {
        const histogram empty(from, to, bins);
        const double edge = empty.edge(k), end = empty.edge(k + 1);
        ASSERT_LE(edge, end);
        for (double number : {std::nextafter(edge, -INFINITY), edge, std::nextafter(end, -INFINITY), end}) {
          histogram one = empty;
          one.take(number);
          EXPECT_EQ(one.count(k), edge <= number && number < end ? 1u : 0u) << k << " of " << bins;
        }
      }
  EXPECT_EQ(histogram(0, 1, 2).count(2), 0u);
  EXPECT_EQ(histogram().count(0), 0u);
}

TEST(counts, are_those_of_each_number) {
  value_counts found = halfway_noted(value_counts(), {1, 2, 2, none, 2, 7});
  EXPECT_EQ(found.count(2), 3u);
  EXPECT_EQ(found.count(3), 0u);
  EXPECT_EQ(found.missing(), 1u);
  for (int i = 0; i < 2000; ++i) found.take(1000 + i);
  EXPECT_EQ(found.counts().size(), value_counts::max_values);
  EXPECT_EQ(found.others(), 2003 - value_counts::max_values);
}

} // namespace
