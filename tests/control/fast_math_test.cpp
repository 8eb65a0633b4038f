// NaN is reported even with -ffast-math.
#include <kanexpr/control/gain_schedule.hpp>
#include <kanexpr/control/lqr.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace kanexpr;

template <class T>
class control_with_fast_math : public testing::Test {};
using types = testing::Types<float, double>;
TYPED_TEST_SUITE(control_with_fast_math, types);

TYPED_TEST(control_with_fast_math, finds_no_gain_at_what_is_no_number) {
  using T = TypeParam;
  const auto table =
      gain_schedule<3>(T(1), T(3), [](T v) { return numeric::fixed_matrix<T, 1, 2>{{v, v * v}}; });
  ASSERT_TRUE(table);
  volatile T none = numeric::not_a_number<T>, large = (std::numeric_limits<T>::max)();
  for (const T gain : table(none).entries) EXPECT_TRUE(numeric::is_nan(gain));
  for (const T gain : table(-none).entries) EXPECT_TRUE(numeric::is_nan(gain));
  EXPECT_EQ(table(large)(0, 0), 3);
  EXPECT_EQ(table(-large)(0, 0), 1);
  EXPECT_EQ(table(T(1.5))(0, 1), T(2.5));
  EXPECT_FALSE(gain_schedule<2>(T(0), T(1), [&](T) { return T(none); }));
}

TYPED_TEST(control_with_fast_math, tells_what_is_not_finite) {
  using T = TypeParam;
  volatile T none = numeric::not_a_number<T>;
  const auto a = numeric::by_rows({{T(0), T(1)}, {T(none), T(0)}}), b = numeric::identity<T, 2>();
  EXPECT_EQ(lqr(a, b, {1, 1}, {1, 1}).status.cause(), "the state matrix A is not finite");
  EXPECT_EQ(lqr(b, b, {1, T(none)}, {1, 1}).status.cause(), "the weights of the states are not finite");
  EXPECT_EQ(discretize(a, b, T(1)).status.cause(), "the state matrix A is not finite");
  EXPECT_EQ(discretize(b, b, T(none)).status.cause(), "the step length is not finite");
  EXPECT_TRUE(lqr(b, b, {1, 1}, {1, 1}));
}

} // namespace
