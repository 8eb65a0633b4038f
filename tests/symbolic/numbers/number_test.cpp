// builds: sanitize
#include <kanexpr/symbolic/graph/graph.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr::symbolic;

constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();

static_assert(exactly(6, 4) == number{3, 2, 0});
static_assert(exactly(6, -4) == number{-3, 2, 0});
static_assert(exactly(0, -5) == number{0, 1, 0});
static_assert(exactly(1, 3) + exactly(1, 6) == exactly(1, 2));
static_assert(exactly(1, 3) - exactly(1, 3) == exactly(0));
static_assert(exactly(-2, 3) * exactly(9, 4) == exactly(-3, 2));
static_assert(exactly(2, 3) / exactly(-4, 9) == exactly(-3, 2));
static_assert(-exactly(2, 3) == exactly(-2, 3));
static_assert(exactly(-1, 2).negative() && !exactly(0).negative() && real(-0.5).negative());
static_assert(exactly(3).integer() && !exactly(3, 2).integer() && !real(0.1).integer());
static_assert(exactly(1, 4).value() == 0.25 && real(0.1).value() == 0.1);

TEST(numbers, are_exact_where_a_double_holds_an_integer) {
  EXPECT_EQ(real(1.0), exactly(1));
  EXPECT_EQ(real(-0.0), exactly(0));
  EXPECT_EQ(real(9007199254740991.0), exactly(9007199254740991));
  EXPECT_FALSE(real(9007199254740992.0).exact());
  EXPECT_FALSE(real(0.5).exact());
  EXPECT_FALSE(real(1e300).exact());
  EXPECT_FALSE(real(std::numeric_limits<double>::infinity()).exact());
  EXPECT_FALSE(real(std::numeric_limits<double>::quiet_NaN()).exact());
}

TEST(numbers, mix_with_doubles) {
  EXPECT_EQ(exactly(1, 2) + real(0.25), real(0.75));
  EXPECT_EQ(real(0.5) + exactly(1, 2), exactly(1));
  EXPECT_EQ(exactly(1, 3) * real(0.1), real((1.0 / 3.0) * 0.1));
  EXPECT_EQ(real(0.1) / exactly(3), real(0.1 / 3));
}

TEST(numbers, become_doubles_where_integers_overflow) {
  EXPECT_EQ(exactly(largest) + exactly(1), real(9223372036854775808.0));
  EXPECT_EQ(exactly(largest) * exactly(2), real(18446744073709551616.0));
  EXPECT_EQ(exactly(1, largest) * exactly(1, 3), real(1.0 / 9223372036854775808.0 * (1.0 / 3.0)));
  EXPECT_EQ(exactly(1, largest) / exactly(largest),
            real(1.0 / 9223372036854775808.0 / 9223372036854775808.0));
  EXPECT_EQ(exactly(largest) + exactly(-largest), exactly(0));
}

TEST(numbers, know_the_integer_without_a_negative) {
  constexpr double value = -9223372036854775808.0;
  EXPECT_EQ(exactly(lowest), real(value));
  EXPECT_EQ(exactly(-largest) - exactly(1), real(value));
  EXPECT_EQ(exactly(largest / 2 + 1) * exactly(-2), real(value));
  EXPECT_EQ(exactly(1, lowest), real(1 / value));
  EXPECT_EQ(-exactly(largest), exactly(-largest));
}

TEST(numbers, obey_the_laws_of_fractions) {
  std::mt19937 engine(1);
  const auto pick = [&engine] {
    return exactly(static_cast<int>(engine() % 2001) - 1000, 1 + static_cast<int>(engine() % 1000));
  };
  for (int i = 0; i < 2000; ++i) {
    const number a = pick(), b = pick(), c = pick();
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_EQ((a - b) + b, a);
    if (b != exactly(0)) {
      EXPECT_EQ((a / b) * b, a);
    }
    EXPECT_NEAR((a + b).value(), a.value() + b.value(), 1e-12);
  }
}

TEST(numbers, are_one_node_each) {
  graph g;
  EXPECT_EQ(g.constant(exactly(0)), graph::zero);
  EXPECT_EQ(g.constant(real(1)), graph::one);
  std::vector<int> nodes;
  const auto value = [](int i) { return i % 2 == 0 ? exactly(largest - i, 7) : real(1e-12 * i + 1e-15); };
  for (int i = 0; i < 1000; ++i) nodes.push_back(g.constant(value(i)));
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(g.constant(value(i)), nodes[static_cast<std::size_t>(i)]);
  EXPECT_EQ(g.size(), 1002);
  EXPECT_NE(g.constant(exactly(1, 2)), g.constant(real(0.5)));
}

} // namespace
