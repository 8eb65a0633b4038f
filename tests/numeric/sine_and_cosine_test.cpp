// builds: clang++ sanitize
// A vector that is wider than those of the processor is returned in memory, which is no concern of one
// program.
#pragma GCC diagnostic ignored "-Wpsabi"

#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/sines_and_cosines.hpp>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace {

using kanexpr::numeric::sine_and_cosine;
namespace elementary = kanexpr::numeric::elementary;

template <class T>
constexpr std::pair<T, T> both(T angle) {
  T sine{}, cosine{};
  sine_and_cosine(angle, sine, cosine);
  return {sine, cosine};
}

template <class T>
auto bits(T x) {
  return std::bit_cast<std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>>(x);
}

/// Angles of every size up to 2e5, and angles near multiples of pi/4, where most digits cancel.
template <class T>
T any_angle(std::mt19937& engine) {
  std::uniform_real_distribution<double> unit(-1, 1);
  switch (engine() % 4) {
  case 0: return static_cast<T>(4 * unit(engine));
  case 1: return static_cast<T>(131072 * unit(engine));
  case 2: return static_cast<T>(std::copysign(std::exp2(60 * std::abs(unit(engine)) - 43), unit(engine)));
  default: {
    auto angle = static_cast<T>(0.7853981633974483 * static_cast<double>(engine() % 160000));
    for (auto i = engine() % 3; i > 0; --i) angle = std::nextafter(angle, T(0));
    return angle;
  }
  }
}

template <class T>
class sine_and_cosine_of : public testing::Test {};
using numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(sine_and_cosine_of, numbers);

// The reference is accurate to 0.51 ulp and uses a separate reduction and separate series; `./dev soak` uses
// one with 113 bits.
TYPED_TEST(sine_and_cosine_of, are_as_exact_as_they_say) {
  std::mt19937 engine(7);
  const auto ulps = [](TypeParam found, double exact) {
    const int digits = std::numeric_limits<TypeParam>::digits;
    return std::abs(static_cast<double>(found) - exact) / std::exp2(std::ilogb(exact) + 1 - digits);
  };
  const double bound = sizeof(TypeParam) == 4 ? 1.5 : 2;
  for (int i = 0; i < 200000; ++i) {
    const auto x = any_angle<TypeParam>(engine);
    if (!(std::abs(x) > std::numeric_limits<TypeParam>::min())) continue;
    const auto [sine, cosine] = both(x);
    ASSERT_LE(ulps(sine, elementary::sin(static_cast<double>(x))), bound) << "sin " << x;
    ASSERT_LE(ulps(cosine, elementary::cos(static_cast<double>(x))), bound) << "cos " << x;
  }
}

TYPED_TEST(sine_and_cosine_of, far_angles_are_those_of_the_library) {
  std::mt19937 engine(8);
  for (int i = 0; i < 10000; ++i) {
    const auto x = static_cast<TypeParam>(std::exp2(18 + static_cast<int>(engine() % 100)) *
                                          (1 + static_cast<double>(engine()) / 4294967296.0));
    EXPECT_EQ(both(x), std::pair(std::sin(x), std::cos(x))) << x;
  }
}

TYPED_TEST(sine_and_cosine_of, what_is_no_number_stays_none) {
  using limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {limits::infinity(), -limits::infinity(), limits::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(both(x).first)) << x;
    EXPECT_TRUE(std::isnan(both(x).second)) << x;
  }
}

TYPED_TEST(sine_and_cosine_of, small_angles_are_their_sines) {
  using limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {TypeParam(0), limits::denorm_min(), 7 * limits::denorm_min(), limits::min(),
                            limits::min() * TypeParam(1.5), limits::epsilon() / 8}) {
    for (const TypeParam signed_angle : {x, -x}) {
      EXPECT_EQ(bits(both(signed_angle).first), bits(signed_angle)) << signed_angle;
      EXPECT_EQ(both(signed_angle).second, 1);
    }
  }
}

TYPED_TEST(sine_and_cosine_of, sines_are_odd_and_cosines_even) {
  std::mt19937 engine(9);
  for (int i = 0; i < 10000; ++i) {
    const auto x = any_angle<TypeParam>(engine);
    EXPECT_EQ(both(-x), std::pair(-both(x).first, both(x).second)) << x;
  }
}

template <class T, std::size_t... count>
void expect_bits_of_each_alone(std::index_sequence<count...>) {
  std::mt19937 engine(10);
  const auto compare = [&]<std::size_t n>() {
    for (int trial = 0; trial < 200; ++trial) {
      T angle[n], sine[n], cosine[n];
      for (T& each : angle) each = any_angle<T>(engine);
      if (trial % 8 == 0) angle[engine() % n] = T(1e9);
      if (trial % 8 == 1) angle[engine() % n] = std::numeric_limits<T>::quiet_NaN();
      kanexpr::numeric::sines_and_cosines(angle, sine, cosine);
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(bits(sine[i]) << 1, bits(both(angle[i]).first) << 1) << n << ": " << angle[i];
        EXPECT_EQ(bits(cosine[i]) << 1, bits(both(angle[i]).second) << 1) << n << ": " << angle[i];
      }
    }
  };
  (compare.template operator()<count + 1>(), ...);
}
TYPED_TEST(sine_and_cosine_of, several_at_once_have_the_bits_of_each_alone) {
  expect_bits_of_each_alone<TypeParam>(std::make_index_sequence<17>{});
}

template <class T, int lanes>
void expect_lanes_alone() {
  typedef T vector __attribute__((vector_size(lanes * sizeof(T))));
  std::mt19937 engine(11);
  for (int trial = 0; trial < 2000; ++trial) {
    vector angle{}, sine, cosine;
    for (int i = 0; i < lanes; ++i) angle[i] = any_angle<T>(engine);
    if (trial % 8 == 0) angle[static_cast<int>(engine() % lanes)] = T(-3e7);
    sine_and_cosine(angle, sine, cosine);
    for (int i = 0; i < lanes; ++i)
      EXPECT_EQ((std::pair<T, T>(T(sine[i]), T(cosine[i]))), both<T>(angle[i])) << T(angle[i]);
  }
}
TYPED_TEST(sine_and_cosine_of, lanes_of_vectors_have_the_bits_of_each_alone) {
  expect_lanes_alone<TypeParam, 2>();
  expect_lanes_alone<TypeParam, 4>();
  expect_lanes_alone<TypeParam, 8>();
}

// Products with several uses may or may not be fused, so a constant may differ in its last bit.
TYPED_TEST(sine_and_cosine_of, constant_expressions_have_them) {
  static constexpr std::array angles{TypeParam(0),   TypeParam(0.5),   TypeParam(-2), TypeParam(3.1415927),
                                     TypeParam(100), TypeParam(-1e5F), TypeParam(1e7)};
  static constexpr auto found = [] {
    std::array<std::pair<TypeParam, TypeParam>, angles.size()> all;
    for (std::size_t i = 0; i < angles.size(); ++i) all[i] = both(angles[i]);
    return all;
  }();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const volatile TypeParam angle = angles[i];
    const TypeParam ulp = std::numeric_limits<TypeParam>::epsilon();
    EXPECT_NEAR(found[i].first, both<TypeParam>(angle).first, ulp) << angle;
    EXPECT_NEAR(found[i].second, both<TypeParam>(angle).second, ulp) << angle;
  }
}

} // namespace
