// builds: sanitize

// Selections with scalars of every type.
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/lower/pack.hpp>

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <complex>
#include <limits>

namespace {

using kanexpr::symbolic::operation;
typedef double pack __attribute__((vector_size(16)));
typedef float small_pack __attribute__((vector_size(16)));

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

template <class T>
T positive(const T& condition, const T& x) {
  return kanexpr::lower::apply<operation::if_positive>(condition, x);
}
template <class T>
T other(const T& condition, const T& x) {
  return kanexpr::lower::apply<operation::if_not_positive>(condition, x);
}

constexpr double conditions[] = {2, 1e-310, 0, -0.0, -1e-310, -3, infinity, -infinity};

template <class T>
void expect_selections() {
  for (const double each : conditions) {
    const T c = static_cast<T>(each);
    for (const double value : {7.0, nan, infinity, -infinity, 0.0}) {
      const T x = static_cast<T>(value), chosen = c > 0 ? positive(c, x) : other(c, x);
      EXPECT_TRUE(chosen == x || (std::isnan(x) && std::isnan(chosen))) << each << ' ' << value;
      EXPECT_EQ(c > 0 ? other(c, x) : positive(c, x), 0) << each << ' ' << value;
    }
  }
  EXPECT_TRUE(std::isnan(positive(static_cast<T>(nan), T(1))));
  EXPECT_TRUE(std::isnan(other(static_cast<T>(nan), T(1))));
}

TEST(selection, is_that_of_numbers) {
  expect_selections<double>();
  expect_selections<float>();
  expect_selections<long double>();
}

template <class Pack>
void expect_lanes() {
  using element = std::remove_cvref_t<decltype(Pack{}[0])>;
  constexpr int lanes = sizeof(Pack) / sizeof(element);
  for (const double each : {2.0, 0.0, -3.0, infinity, nan}) {
    Pack c, x;
    for (int i = 0; i < lanes; ++i) {
      c[i] = static_cast<element>(i % 2 == 0 ? each : -each);
      x[i] = i == 1 ? static_cast<element>(nan) : static_cast<element>(i + 1);
    }
    const Pack first = positive(c, x), second = other(c, x);
    for (int i = 0; i < lanes; ++i) {
      const element own_c = c[i], own_x = x[i];
      const element expected_first = positive(own_c, own_x), expected_second = other(own_c, own_x);
      EXPECT_TRUE(first[i] == expected_first || (std::isnan(first[i]) && std::isnan(expected_first)));
      EXPECT_TRUE(second[i] == expected_second || (std::isnan(second[i]) && std::isnan(expected_second)));
    }
  }
}

TEST(selection, is_made_lane_by_lane) {
  expect_lanes<pack>();
  expect_lanes<small_pack>();
}

TEST(selection, of_complex_numbers_goes_by_the_real_part) {
  using number = std::complex<double>;
  const number x(1, 2);
  EXPECT_EQ(positive(number(0.5, -3), x), x);
  EXPECT_EQ(other(number(0.5, -3), x), number());
  EXPECT_EQ(positive(number(0, 1), x), number());
  EXPECT_EQ(other(number(0, 1), x), x);
  EXPECT_TRUE(std::isnan(positive(number(nan, 1), x).real()));
  EXPECT_TRUE(std::isnan(other(number(nan, 1), x).real()));
}

TEST(selection, differentiates_itself) {
  using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
  const number x(3, 2, 0), c(0.5, 2, 1);
  EXPECT_EQ(positive(c, x).value(), 3);
  EXPECT_EQ(positive(c, x).derivatives(), Eigen::Vector2d(1, 0));
  EXPECT_EQ(other(c, x).value(), 0);
  EXPECT_EQ(other(number(-c), x).derivatives(), Eigen::Vector2d(1, 0));
}

} // namespace
