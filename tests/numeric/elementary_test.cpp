#include "kanexpr/numeric/elementary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

namespace {

namespace elementary = kanexpr::numeric::elementary;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double pi = 3.141592653589793;

constexpr std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

constexpr bool is_nan(double x) { return (bits(x) << 1) > (bits(infinity) << 1); }

// The sign of zero counts; NaN equals NaN.
constexpr bool same(double x, double y) { return is_nan(x) ? is_nan(y) : bits(x) == bits(y); }

// The position on the line of doubles, on which neighbors differ by one.
std::int64_t position(double x) {
  const auto magnitude = static_cast<std::int64_t>(bits(x) & ~(std::uint64_t{1} << 63));
  return std::signbit(x) ? -magnitude : magnitude;
}

std::int64_t ulps_between(double x, double y) {
  if (is_nan(x) || is_nan(y)) return is_nan(x) && is_nan(y) ? 0 : std::numeric_limits<std::int64_t>::max();
  return std::abs(position(x) - position(y));
}

// Within one ulp and of the same sign.
bool close(double x, double y) {
  return ulps_between(x, y) <= 1 && (is_nan(x) || std::signbit(x) == std::signbit(y));
}

// Values of every magnitude, including subnormal numbers and infinities. The only NaN is a quiet one, because
// libm's pow(nan, 0) is 1 only for quiet NaNs.
double any_double(std::mt19937_64& engine) {
  const double x = std::bit_cast<double>(engine());
  return is_nan(x) ? nan : x;
}

using unary = double (*)(double);

void expect_close_to_libm(unary function, unary libm, double from, double to, std::int64_t ulps = 1) {
  std::mt19937_64 engine{20240229};
  std::uniform_real_distribution<double> arguments{from, to};
  for (int i = 0; i < 20000; ++i) {
    const double x = arguments(engine);
    ASSERT_LE(ulps_between(function(x), libm(x)), ulps) << "x = " << x;
  }
}

void expect_close_to_libm_on_all_doubles(unary function, unary libm) {
  std::mt19937_64 engine{20240301};
  for (int i = 0; i < 50000; ++i) {
    const double x = any_double(engine);
    ASSERT_LE(ulps_between(function(x), libm(x)), 1) << "x = " << x;
  }
}

TEST(elementary, sqrt_is_the_correctly_rounded_one_of_the_hardware) {
  std::mt19937_64 engine{1};
  for (int i = 0; i < 200000; ++i) {
    const double x = any_double(engine);
    ASSERT_TRUE(same(elementary::sqrt(x), std::sqrt(x))) << "x = " << x;
  }
  // The roots closest to the midpoint of two doubles are those of numbers next to powers of two and to
  // squares.
  for (double n = 1; n < 20000; ++n) {
    ASSERT_EQ(elementary::sqrt(n * n), n);
    for (const double x : {std::nextafter(n * n, 0.0), std::nextafter(n * n, infinity)}) {
      ASSERT_EQ(elementary::sqrt(x), std::sqrt(x)) << "n = " << n;
    }
  }
}

TEST(elementary, trigonometric_functions) {
  for (const double range : {1e-3, 1.0, 10.0, 1e5, 1e15}) {
    expect_close_to_libm(elementary::sin, std::sin, -range, range);
    expect_close_to_libm(elementary::cos, std::cos, -range, range);
    expect_close_to_libm(elementary::tan, std::tan, -range, range);
  }
  expect_close_to_libm_on_all_doubles(elementary::sin, std::sin);
  expect_close_to_libm_on_all_doubles(elementary::cos, std::cos);
  expect_close_to_libm_on_all_doubles(elementary::tan, std::tan);
}

TEST(elementary, trigonometric_functions_next_to_multiples_of_a_right_angle) {
  for (double x = pi / 2; x < 2000; x += pi / 2) {
    EXPECT_TRUE(close(elementary::sin(x), std::sin(x))) << x;
    EXPECT_TRUE(close(elementary::cos(x), std::cos(x))) << x;
    EXPECT_TRUE(close(elementary::tan(x), std::tan(x))) << x;
  }
  // The double closest to such a multiple (Muller, "Elementary Functions", on the worst cases of range
  // reduction). The reference was computed with mpmath; the cosine in glibc 2.36 has an error of 8 ulp.
  EXPECT_EQ(elementary::cos(0x1.6ac5b262ca1ffp+849), -4.687165924254627611122583e-19);
  EXPECT_EQ(elementary::sin(0x1.6ac5b262ca1ffp+849), 1);
}

TEST(elementary, inverse_trigonometric_functions) {
  expect_close_to_libm(elementary::asin, std::asin, -1, 1);
  expect_close_to_libm(elementary::acos, std::acos, -1, 1);
  expect_close_to_libm(elementary::asin, std::asin, -1e-3, 1e-3);
  expect_close_to_libm(elementary::acos, std::acos, 0.999999, 1);
  expect_close_to_libm(elementary::atan, std::atan, -3, 3);
  expect_close_to_libm_on_all_doubles(elementary::asin, std::asin);
  expect_close_to_libm_on_all_doubles(elementary::acos, std::acos);
  expect_close_to_libm_on_all_doubles(elementary::atan, std::atan);

  std::mt19937_64 engine{2};
  std::uniform_real_distribution<double> coordinates{-10, 10};
  for (int i = 0; i < 50000; ++i) {
    const std::pair near{coordinates(engine), coordinates(engine)};
    const std::pair any{any_double(engine), any_double(engine)};
    for (const auto& [y, x] : {near, any}) {
      ASSERT_LE(ulps_between(elementary::atan2(y, x), std::atan2(y, x)), 1) << y << ", " << x;
    }
  }
}

TEST(elementary, exponential_and_logarithm) {
  expect_close_to_libm(elementary::exp, std::exp, -2, 2);
  expect_close_to_libm(elementary::exp, std::exp, -750, 715);
  expect_close_to_libm(elementary::log, std::log, 0, 2);
  expect_close_to_libm(elementary::log, std::log, 0.999, 1.001);
  expect_close_to_libm_on_all_doubles(elementary::exp, std::exp);
  expect_close_to_libm_on_all_doubles(elementary::log, std::log);
}

// Compared with the long double functions of the C library, because its double functions have errors of up to
// 2 ulp.
TEST(elementary, hyperbolic_tangent) {
  const unary precise = [](double x) { return static_cast<double>(std::tanh(static_cast<long double>(x))); };
  for (const double range : {1e-8, 0.1, 0.51, 2.0, 25.0})
    expect_close_to_libm(elementary::tanh, precise, -range, range);
  expect_close_to_libm_on_all_doubles(elementary::tanh, precise);
  for (double x = 18; x < 21; x = std::nextafter(x, 21) + 1e-4)
    ASSERT_TRUE(close(elementary::tanh(x), precise(x))) << x;
}

TEST(elementary, hyperbolic_sine_and_cosine) {
  const unary sine = [](double x) { return static_cast<double>(std::sinh(static_cast<long double>(x))); };
  const unary cosine = [](double x) { return static_cast<double>(std::cosh(static_cast<long double>(x))); };
  for (const double range : {1e-8, 0.1, 0.51, 2.0, 45.0, 712.0}) {
    expect_close_to_libm(elementary::sinh, sine, -range, range);
    expect_close_to_libm(elementary::cosh, cosine, -range, range);
  }
  expect_close_to_libm_on_all_doubles(elementary::sinh, sine);
  expect_close_to_libm_on_all_doubles(elementary::cosh, cosine);
}

TEST(elementary, cube_root) {
  const unary precise = [](double x) { return static_cast<double>(std::cbrt(static_cast<long double>(x))); };
  for (const double range : {1e-8, 1.0, 100.0, 1e9})
    expect_close_to_libm(elementary::cbrt, precise, -range, range);
  expect_close_to_libm_on_all_doubles(elementary::cbrt, precise);
  for (double n = -200; n <= 200; ++n) ASSERT_EQ(elementary::cbrt(n * n * n), n);
}

TEST(elementary, error_function) {
  const unary precise = [](double x) { return static_cast<double>(std::erf(static_cast<long double>(x))); };
  for (const double range : {1e-8, 0.1, 1.0, 2.0, 3.0, 6.5})
    expect_close_to_libm(elementary::erf, precise, -range, range);
  expect_close_to_libm_on_all_doubles(elementary::erf, precise);
  for (const double edge : {2.0, 6.0})
    for (double x = edge - 1e-3; x < edge + 1e-3; x += 1e-6)
      ASSERT_TRUE(close(elementary::erf(x), precise(x))) << x;
}

TEST(elementary, wrapping_is_an_exact_remainder) {
  const unary remainder = [](double x) {
    const double r = std::remainder(x, 2 * pi);
    return r == pi ? -pi : r;
  };
  for (const double range : {1.0, 10.0, 1e5, 1e15})
    expect_close_to_libm(elementary::wrap_to_pi, remainder, -range, range, 0);
  std::mt19937_64 engine{4};
  for (int i = 0; i < 20000; ++i) {
    const double x = any_double(engine);
    ASSERT_TRUE(same(elementary::wrap_to_pi(x), remainder(x))) << x;
  }
  for (int n = -41; n <= 41; ++n)
    for (const double x : {n * pi, std::nextafter(n * pi, infinity), std::nextafter(n * pi, -infinity)}) {
      const double r = elementary::wrap_to_pi(x);
      ASSERT_TRUE(same(r, remainder(x))) << x;
      ASSERT_TRUE(-pi <= r && r < pi) << x;
    }
}

void expect_power_close_to_libm(double x, double y, std::int64_t ulps) {
  ASSERT_LE(ulps_between(elementary::pow(x, y), std::pow(x, y)), ulps) << x << ", " << y;
}

TEST(elementary, power) {
  std::mt19937_64 engine{3};
  std::uniform_real_distribution<double> bases{0, 10};
  std::uniform_real_distribution<double> exponents{-20, 20};
  std::uniform_int_distribution<int> integers{-40, 40};
  std::uniform_real_distribution<double> large_exponents{-400, 400};
  for (int i = 0; i < 50000; ++i) {
    expect_power_close_to_libm(bases(engine), exponents(engine), 1);
    expect_power_close_to_libm(-bases(engine), integers(engine), 1);
    expect_power_close_to_libm(bases(engine), large_exponents(engine), 2);
    expect_power_close_to_libm(any_double(engine), any_double(engine), 2);
    expect_power_close_to_libm(any_double(engine), integers(engine), 1);
  }
  for (int n = 0; n <= 33; ++n) EXPECT_EQ(elementary::pow(-3.0, n), (n % 2 == 0 ? 1 : -1) * std::pow(3.0, n));
  for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(elementary::pow(2.0, n), std::ldexp(1.0, n));
  for (double x = 0; x < 100; x += 0.37) EXPECT_EQ(elementary::pow(x, 0.5), std::sqrt(x));
}

// clang-format off
constexpr double special_values[] = {
    0.0, -0.0, 0.25, -0.25, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, -2.0, 3.0, -3.0, 1e300, -1e300, 1e-300,
    0x1p52, -0x1p52, 0x1.fffffffffffffp52, 0x1p53, smallest, -smallest, largest, -largest, infinity,
    -infinity, nan, 709.782712893384, 709.7827128933841, -745.1332191019411, -745.1332191019412};
// clang-format on

TEST(elementary, special_values) {
  for (const double x : special_values) {
    EXPECT_TRUE(same(elementary::abs(x), std::fabs(x))) << x;
    EXPECT_TRUE(same(elementary::floor(x), std::floor(x))) << x;
    EXPECT_TRUE(same(elementary::sqrt(x), std::sqrt(x))) << x;
    EXPECT_TRUE(close(elementary::sin(x), std::sin(x))) << x;
    EXPECT_TRUE(close(elementary::cos(x), std::cos(x))) << x;
    EXPECT_TRUE(close(elementary::tan(x), std::tan(x))) << x;
    EXPECT_TRUE(close(elementary::asin(x), std::asin(x))) << x;
    EXPECT_TRUE(close(elementary::acos(x), std::acos(x))) << x;
    EXPECT_TRUE(close(elementary::atan(x), std::atan(x))) << x;
    EXPECT_TRUE(close(elementary::exp(x), std::exp(x))) << x;
    EXPECT_TRUE(close(elementary::log(x), std::log(x))) << x;
    EXPECT_LE(ulps_between(elementary::sinh(x), std::sinh(x)), 2) << x;
    EXPECT_LE(ulps_between(elementary::cosh(x), std::cosh(x)), 2) << x;
    EXPECT_EQ(std::signbit(elementary::sinh(x)), std::signbit(std::sinh(x))) << x;
    EXPECT_LE(ulps_between(elementary::tanh(x), std::tanh(x)), 2) << x;
    EXPECT_EQ(std::signbit(elementary::tanh(x)), std::signbit(std::tanh(x))) << x;
    EXPECT_TRUE(close(elementary::cbrt(x), std::cbrt(x))) << x;
    EXPECT_TRUE(close(elementary::erf(x), std::erf(x))) << x;
    EXPECT_TRUE(same(elementary::wrap_to_pi(x), std::remainder(x, 2 * pi))) << x;
    for (const double y : special_values) {
      EXPECT_TRUE(close(elementary::atan2(y, x), std::atan2(y, x))) << y << ", " << x;
      EXPECT_TRUE(close(elementary::pow(x, y), std::pow(x, y))) << x << ", " << y;
    }
  }
}

TEST(elementary, floor_rounds_down) {
  expect_close_to_libm(elementary::floor, std::floor, -10, 10, 0);
  expect_close_to_libm(elementary::floor, std::floor, -1e15, 1e15, 0);
}

static_assert(elementary::sqrt(2.0) == 1.4142135623730951 && elementary::sqrt(144.0) == 12);
static_assert(is_nan(elementary::sqrt(-1.0)) && same(elementary::sqrt(-0.0), -0.0));
static_assert(elementary::sin(0.0) == 0 && same(elementary::sin(-0.0), -0.0) && elementary::cos(0.0) == 1);
static_assert(elementary::sin(pi / 6) == 0.49999999999999994);
static_assert(elementary::tan(pi / 4) == 0.9999999999999999);
static_assert(elementary::sin(1e22) == -0.8522008497671888 && is_nan(elementary::cos(infinity)));
static_assert(elementary::asin(1.0) == pi / 2 && elementary::acos(-1.0) == pi);
static_assert(is_nan(elementary::asin(2.0)));
static_assert(elementary::atan(1.0) == pi / 4 && elementary::atan(-infinity) == -pi / 2);
static_assert(elementary::atan2(0.0, -1.0) == pi && elementary::atan2(-0.0, -1.0) == -pi);
static_assert(elementary::exp(0.0) == 1 && elementary::exp(1.0) == 2.718281828459045);
static_assert(elementary::exp(710.0) == infinity && elementary::exp(-746.0) == 0);
static_assert(elementary::exp(-745.0) == smallest);
static_assert(elementary::sinh(1.0) == 1.1752011936438014 && same(elementary::sinh(-0.0), -0.0));
static_assert(elementary::cosh(1.0) == 1.5430806348152437 && elementary::cosh(0.0) == 1);
static_assert(elementary::sinh(710.0) < infinity && elementary::sinh(-711.0) == -infinity);
static_assert(elementary::tanh(1.0) == 0.7615941559557649 && same(elementary::tanh(-0.0), -0.0));
static_assert(elementary::tanh(-infinity) == -1 && elementary::tanh(smallest) == smallest);
static_assert(elementary::cbrt(27.0) == 3 && elementary::cbrt(-1e-300) == -1e-100);
static_assert(same(elementary::cbrt(-0.0), -0.0) && elementary::cbrt(-infinity) == -infinity);
static_assert(elementary::erf(0.5) == 0.5204998778130465 && same(elementary::erf(-0.0), -0.0));
static_assert(elementary::erf(infinity) == 1 && is_nan(elementary::erf(nan)));
static_assert(elementary::wrap_to_pi(pi) == -pi && elementary::wrap_to_pi(-pi) == -pi);
static_assert(elementary::wrap_to_pi(7.0) == 7.0 - 2 * pi && is_nan(elementary::wrap_to_pi(infinity)));
static_assert(elementary::log(1.0) == 0 && elementary::log(0.0) == -infinity);
static_assert(is_nan(elementary::log(-1.0)));
static_assert(elementary::pow(3.0, 4.0) == 81 && elementary::pow(-2.0, -3.0) == -0.125);
static_assert(elementary::pow(2.0, 0.5) == elementary::sqrt(2.0) && is_nan(elementary::pow(-8.0, 1.0 / 3)));
static_assert(elementary::pow(largest, 15.0) == infinity && elementary::pow(smallest, 15.0) == 0);
static_assert(elementary::pow(largest, -15.0) == 0 && elementary::pow(smallest, -15.0) == infinity);
static_assert(elementary::abs(-2.5) == 2.5 && elementary::sign(-2.5) == -1 && elementary::sign(0.0) == 0);
static_assert(elementary::floor(-0.5) == -1 && elementary::floor(1e300) == 1e300);

// clang-format off
constexpr std::array<double, 42> arguments = {
    0.0, -0.0, 1e-320, 1e-17, -3e-9, 0.0001, 0.1, -0.2, 0.3, 0.4375, -0.49999999999999994, 0.5, 0.7, -0.75,
    0.7853981633974483, 0.9, 0.99999999, -1.0, 1.0000000001, 1.1, 1.4142135623730951, 1.5707963267948966,
    -2.0, 2.5, 2.718281828459045, 3.141592653589793, -4.7, 7.3890561, 10.0, 22.0, -31.4159, 100.5, 355.0,
    700.123, -744.9, 12345.678, 1e5, -98765.4321, 1e10, 123456789012345.0, 1e22, -1.7e308};
// clang-format on

constexpr std::size_t results_per_argument = 22;
using results = std::array<std::uint64_t, results_per_argument * arguments.size()>;

// Neighbors in the table form the argument pairs for functions of two arguments.
constexpr results evaluate(const std::array<double, arguments.size()>& inputs) {
  results result{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double x = inputs[i];
    const double y = inputs[(i + 7) % inputs.size()];
    const double positive = elementary::abs(x);
    for (const double value : {elementary::sqrt(positive),
                               elementary::sin(x),
                               elementary::cos(x),
                               elementary::tan(x),
                               elementary::asin(x),
                               elementary::acos(x),
                               elementary::atan(x),
                               elementary::atan2(y, x),
                               elementary::exp(x),
                               elementary::log(positive),
                               elementary::pow(positive, y),
                               elementary::pow(x, 7.0),
                               elementary::pow(positive, -1.5),
                               elementary::abs(x),
                               elementary::sign(x),
                               elementary::floor(x),
                               elementary::sinh(x),
                               elementary::cosh(x),
                               elementary::tanh(x),
                               elementary::cbrt(x),
                               elementary::erf(x),
                               elementary::wrap_to_pi(x)}) {
      result[next++] = bits(value);
    }
  }
  return result;
}

constexpr results at_compile_time = evaluate(arguments);

TEST(elementary, same_bits_at_compile_time_and_at_run_time) {
  std::array<double, arguments.size()> inputs{};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const volatile double opaque = arguments[i];
    inputs[i] = opaque;
  }
  const results at_run_time = evaluate(inputs);
  for (std::size_t i = 0; i < at_run_time.size(); ++i) {
    EXPECT_EQ(at_run_time[i], at_compile_time[i])
        << "function " << i % results_per_argument << " of " << arguments[i / results_per_argument];
  }
}

} // namespace
