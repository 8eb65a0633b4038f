// NaN is recognized even with -ffast-math.
#include <kanexpr/ensembles/reduction.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace {

using namespace kanexpr;

TEST(fast_math, leaves_out_what_is_not_a_number) {
  volatile std::uint64_t bits = 0x7ff8000000000000; // hidden from the optimizer
  reduction all[]{statistics_of(""), quantiles_of(""), histogram_of("", 0, 1, 2), counts_of("")};
  for (reduction& each : all)
    for (double number : {0.25, std::bit_cast<double>(std::uint64_t{bits}), 0.75}) each.take(number);
  const auto& numbers = std::get<statistics>(all[0].what);
  EXPECT_EQ(numbers.missing(), 1u);
  EXPECT_EQ(numbers.mean(), 0.5);
  EXPECT_EQ(numbers.greatest(), 0.75);
  const auto& quantiles = std::get<quantile_sketch>(all[1].what);
  EXPECT_EQ(quantiles.missing(), 1u);
  EXPECT_EQ(quantiles.quantile(0.5), 0.25);
  const auto& bins = std::get<histogram>(all[2].what);
  EXPECT_EQ(bins.missing(), 1u);
  EXPECT_EQ(bins.count(0) + bins.count(1), 2u);
  EXPECT_EQ(std::get<value_counts>(all[3].what).missing(), 1u);
}

} // namespace
