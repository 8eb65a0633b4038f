// Values that are not finite are reported even with -ffast-math.
#include <kanexpr/lower/complex_math.hpp>

#include <gtest/gtest.h>

#include <complex>

namespace {

template <class T>
class fast_math : public testing::Test {};
using types = testing::Types<float, double, std::complex<float>, std::complex<double>>;
TYPED_TEST_SUITE(fast_math, types);

TYPED_TEST(fast_math, leaves_finiteness_as_it_is) {
  using math = kanexpr::lower::scalar_math<TypeParam>;
  volatile float given[]{0, 1, 1e-30F, 1e30F}; // the compiler must not know
  const auto of = [&](int i) { return math::from(given[i]); };
  EXPECT_TRUE(math::is_finite(of(1)));
  EXPECT_TRUE(math::is_finite(TypeParam(of(0) / of(1))));
  EXPECT_TRUE(math::is_finite(TypeParam(-of(3))));
  EXPECT_FALSE(math::is_finite(TypeParam(of(1) / of(0))));
  EXPECT_FALSE(math::is_finite(TypeParam(-of(1) / of(0))));
  EXPECT_FALSE(math::is_finite(TypeParam(of(0) / of(0))));
  TypeParam large = of(3);
  for (int i = 0; i < 5; ++i) large *= large;
  EXPECT_FALSE(math::is_finite(large));
}

} // namespace
