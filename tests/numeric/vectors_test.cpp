#include <kanexpr/numeric/square_roots.hpp>
#include <kanexpr/numeric/vectors.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

namespace {

using namespace kanexpr::numeric::detail;

template <class Vector>
class Vectors : public testing::Test {};

using all_widths =
    testing::Types<vector_of<double, 1>::type, vector_of<double, 2>::type, vector_of<double, 4>::type,
                   vector_of<double, 8>::type, vector_of<float, 2>::type, vector_of<float, 4>::type,
                   vector_of<float, 8>::type, vector_of<float, 16>::type>;
TYPED_TEST_SUITE(Vectors, all_widths, );

template <class T>
void set(T& vector, [[maybe_unused]] std::size_t lane, number_of<T> value) {
  if constexpr (lanes<T>::count == 1)
    vector = value;
  else
    vector[lane] = value;
}

TYPED_TEST(Vectors, TellWhetherTheHighestBitOfSomeLaneIsSet) {
  using T = TypeParam;
  T all{};
  for (std::size_t lane = 0; lane < lanes<T>::count; ++lane)
    set(all, lane, std::numeric_limits<number_of<T>>::quiet_NaN()); // all bits of the exponent, no sign
  EXPECT_FALSE(is_set_in_a_lane(__builtin_bit_cast(bits_of<T>, all)));
  for (std::size_t lane = 0; lane < lanes<T>::count; ++lane) {
    T one = all;
    set(one, lane, -number_of<T>{});
    EXPECT_TRUE(is_set_in_a_lane(__builtin_bit_cast(bits_of<T>, one))) << "lane " << lane;
  }
}

TYPED_TEST(Vectors, TellWhetherAComparisonHoldsInSomeLane) {
  using T = TypeParam;
  if constexpr (lanes<T>::count > 1) {
    const T zeros{};
    EXPECT_FALSE(is_set_in_a_lane(zeros > T{}));
    for (std::size_t lane = 0; lane < lanes<T>::count; ++lane) {
      T one{};
      one[lane] = 1;
      EXPECT_TRUE(is_set_in_a_lane(one > zeros)) << "lane " << lane;
    }
  }
}

template <std::size_t count>
void expect_lower_halves() {
  using words = typename vector_of<std::uint64_t, count>::type;
  words all{};
  for (std::size_t lane = 0; lane < count; ++lane) all[lane] = 0xffff'ffff'0000'0000 + lane;
  const auto halves = lower_halves(all);
  for (std::size_t lane = 0; lane < count; ++lane) EXPECT_EQ(halves[lane], lane);
}

TEST(LowerHalves, AreThoseOfEachLane) {
  EXPECT_EQ(lower_halves(std::uint64_t{0xffff'ffff'1234'5678}), 0x1234'5678);
  expect_lower_halves<2>();
  expect_lower_halves<4>();
  expect_lower_halves<8>();
}

TEST(Converted, HasTheValuesOfEachLane) {
  const vector_of<float, 4>::type given{1.5F, -0.F, 0x1p-149F, -std::numeric_limits<float>::infinity()};
  const auto wide = converted<vector_of<double, 4>::type>(given);
  for (std::size_t lane = 0; lane < 4; ++lane)
    EXPECT_EQ(__builtin_bit_cast(std::uint64_t, double(wide[lane])),
              __builtin_bit_cast(std::uint64_t, double{given[lane]}));
}

TYPED_TEST(Vectors, HaveTheSquareRootsOfTheirLanes) {
  using T = TypeParam;
  if constexpr (lanes<T>::count > 1) {
    using number = number_of<T>;
    const number some[]{0,
                        number(-0.0),
                        2,
                        3,
                        number(0.1),
                        std::numeric_limits<number>::denorm_min(),
                        std::numeric_limits<number>::infinity(),
                        std::numeric_limits<number>::max(),
                        -1};
    for (std::size_t first = 0; first < std::size(some); ++first) {
      T x{};
      for (std::size_t lane = 0; lane < lanes<T>::count; ++lane)
        x[lane] = some[(first + lane) % std::size(some)];
      const T roots = kanexpr::numeric::square_roots(x);
      for (std::size_t lane = 0; lane < lanes<T>::count; ++lane) {
        const number expected = std::sqrt(x[lane]);
        if (std::isnan(expected))
          EXPECT_TRUE(std::isnan(roots[lane]));
        else
          EXPECT_EQ(roots[lane], expected) << "lane " << lane;
      }
    }
  }
}

} // namespace
