// Linear-quadratic regulators and discrete forms for numbers near the ends of their range and for widely
// spread rates: the results are correct, or a status reports the true cause.
// builds: clang++ sanitize
#include <kanexpr/control/discretize.hpp>
#include <kanexpr/control/lqr.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace {

using namespace kanexpr;
using control::time_domain;

template <class T, int n>
using square = numeric::fixed_matrix<T, n, n>;
template <class T, int n>
using column = numeric::fixed_matrix<T, n, 1>;

constexpr std::string_view too_inaccurate = "the Riccati equation could not be solved to working precision",
                           too_large = "the solution of the Riccati equation overflows",
                           not_stabilizable = "the system is not stabilizable to working precision: "
                                              "its inputs do not reach a motion that does not decay",
                           too_far = "the motion of the linear system over the step overflows";

// For a double integrator, K = (√(q₁/r), √(q₂/r + 2 √(q₁/r)/b)).
template <class T>
void expect_gain_of_a_double_integrator(T b, T q1, T q2, T r) {
  const auto found =
      lqr(numeric::by_rows({{T(0), T(1)}, {T(0), T(0)}}), column<T, 2>{{T(0), b}}, {q1, q2}, {r});
  ASSERT_TRUE(found) << found.status;
  const long double first = std::sqrt(static_cast<long double>(q1) / static_cast<long double>(r)),
                    second = std::sqrt(static_cast<long double>(q2) / static_cast<long double>(r) +
                                       2 * first / static_cast<long double>(b));
  const long double rounding = 16 * static_cast<long double>(std::numeric_limits<T>::epsilon());
  EXPECT_NEAR(static_cast<double>(found.K(0, 0) / first), 1, static_cast<double>(rounding));
  EXPECT_NEAR(static_cast<double>(found.K(0, 1) / second), 1, static_cast<double>(rounding));
}

TEST(lqr_of_extreme_numbers, is_right_where_products_of_its_matrices_are_too_large_or_too_small) {
  expect_gain_of_a_double_integrator<double>(1e-170, 4, 3, 1); // b²/r vanishes
  expect_gain_of_a_double_integrator<double>(1e-170, 4e-200, 3, 1e100);
  expect_gain_of_a_double_integrator<double>(1e-3, 4e-300, 3e-300, 1e300);
  expect_gain_of_a_double_integrator<double>(1, 4e300, 3e300, 1e300);
  expect_gain_of_a_double_integrator<double>(1e170, 4e-100, 3e-220, 1);
  expect_gain_of_a_double_integrator<float>(1e-25f, 4, 3, 1);
  expect_gain_of_a_double_integrator<float>(1, 4e-37f, 3e-37f, 1e-37f);
  expect_gain_of_a_double_integrator<float>(1, 4e36f, 3e36f, 1e36f);
}

TEST(lqr_of_extreme_numbers, does_not_depend_on_the_unit_of_time) {
  const square<double, 2> a = numeric::by_rows({{0.5, 1.0}, {-1.0, 0.2}});
  const column<double, 2> b{{1, 2}};
  const auto plain = lqr(a, b, {1, 1}, {1});
  ASSERT_TRUE(plain);
  for (const double rate : {0x1p-600, 0x1p600}) {
    const auto found = lqr(rate * a, std::sqrt(rate) * b, {rate, rate}, {1});
    ASSERT_TRUE(found) << found.status;
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(found.K(0, i) / std::sqrt(rate), plain.K(0, i), 1e-14);
  }
  // The smallest input reverses the motion that grows like exp(t).
  const auto unweighted = lqr(square<double, 1>{{1}}, column<double, 1>{{1}}, {0}, {1e300});
  ASSERT_TRUE(unweighted) << unweighted.status;
  EXPECT_NEAR(unweighted.K(0), 2, 1e-15);
  EXPECT_NEAR(unweighted.P(0), 2e300, 1e285);
}

TEST(lqr_of_extreme_numbers, says_what_is_too_large) {
  EXPECT_EQ(lqr(square<double, 1>{{1e10}}, column<double, 1>{{1}}, {0}, {1e300}).status.cause(), too_large);
  EXPECT_EQ(dlqr(square<double, 1>{{1e200}}, column<double, 1>{{1}}, {1}, {1}).status.cause(), too_large);
  EXPECT_EQ(dlqr(square<double, 1>{{1e8}}, column<double, 1>{{1}}, {1}, {1}).status.cause(), too_inaccurate);
}

TEST(lqr_of_extreme_numbers, looks_at_weights_of_any_size) {
  const square<double, 2> a = numeric::by_rows({{0.0, 1.0}, {0.0, 0.0}}), b = numeric::identity<double, 2>();
  const auto cause = [&](const square<double, 2>& q, const square<double, 2>& r) {
    return lqr(a, b, q, r).status.cause();
  };
  EXPECT_EQ(cause(numeric::by_rows({{1e-300, 1e300}, {1e300, 1e-300}}), b),
            "the weights of the states are not positive semidefinite");
  EXPECT_EQ(cause(numeric::by_rows({{1e300, 1e300}, {-1e300, 1e300}}), b),
            "the weights of the states are not symmetric");
  EXPECT_EQ(cause(b, numeric::by_rows({{1e-300, 1e300}, {1e300, 1e-300}})),
            "the weights of the inputs are not positive definite");
  EXPECT_EQ(cause(numeric::by_rows({{1e308, 1.5e308}, {1.5e308, 1e308}}), b),
            "the weights of the states are not positive semidefinite");
  EXPECT_TRUE(lqr(numeric::by_rows({{-1.0, 0.5}, {0.0, -1.0}}), b, {1e-320, 1}, {1, 1}));
}

// The residual Aᵀ P + P A − P B Bᵀ P + Q with Q = 1, R = 1, relative to its terms.
template <class T>
double left_of_equation(const square<T, 2>& a, const column<T, 2>& b, const square<T, 2>& p) {
  double most = 0, terms = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      double rest = i == j ? 1 : 0, sum = rest, to_i = 0, to_j = 0;
      const auto add = [&](double term) { rest += term, sum += std::abs(term); };
      for (int k = 0; k < 2; ++k) {
        add(static_cast<double>(p(i, k)) * static_cast<double>(a(k, j)));
        add(static_cast<double>(p(j, k)) * static_cast<double>(a(k, i)));
        to_i += static_cast<double>(p(i, k)) * static_cast<double>(b(k));
        to_j += static_cast<double>(p(j, k)) * static_cast<double>(b(k));
      }
      add(-to_i * to_j);
      most = std::max(most, std::abs(rest));
      terms = std::max(terms, sum);
    }
  return most / terms;
}

// Stabilizable systems with a weight on each state: a feedback exists, and only the precision may not suffice
// to find it.
template <class T>
void expect_true_sentences(int most_decades, int solved_decades) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (const double slow : {-1.0, 0.0, 1.0})
    for (const double sign : {-1.0, 1.0})
      for (int decades = 1; decades <= most_decades; ++decades) {
        const double fast = sign * std::pow(10, decades);
        const double turned[2][2]{{c * c * slow + s * s * fast, c * s * (slow - fast)},
                                  {c * s * (slow - fast), s * s * slow + c * c * fast}},
            companion[2][2]{{0, 1}, {-slow * fast, slow + fast}}, alone[2][2]{{slow, 0}, {0, fast}};
        for (const auto& each :
             {numeric::by_rows(turned), numeric::by_rows(companion), numeric::by_rows(alone)}) {
          const auto a = each.template cast<T>();
          const column<T, 2> b{{each(0, 1) == 1 ? T(0) : T(1), T(1)}};
          const auto found = lqr(a, b, {1, 1}, {1});
          if (found) {
            EXPECT_LE(left_of_equation(a, b, found.P), 1e5 * double{std::numeric_limits<T>::epsilon()});
          } else {
            EXPECT_EQ(found.status.cause(), too_inaccurate) << slow << ' ' << fast;
          }
          EXPECT_TRUE(found || decades > solved_decades) << slow << ' ' << fast;
        }
      }
}

TEST(lqr_of_extreme_numbers, blames_digits_and_not_the_system_for_rates_far_apart) {
  expect_true_sentences<double>(24, 6);
  expect_true_sentences<float>(12, 2);
}

TEST(lqr_of_extreme_numbers, still_finds_what_no_input_reaches) {
  const column<double, 2> b{{0, 1}};
  for (const double fast : {1e-12, 1.0, 1e12, 1e200})
    for (const double rate : {0.0, 1e-9, 1e9}) {
      const square<double, 2> a = numeric::by_rows({{rate, 0.0}, {1.0, fast}});
      EXPECT_EQ(lqr(a, b, {1, 1}, {1}).status.cause(), not_stabilizable) << fast << ' ' << rate;
    }
  EXPECT_EQ(dlqr(numeric::by_rows({{-1.0, 0.0}, {1.0, 1e5}}), b, {1, 1}, {1}).status.cause(),
            not_stabilizable);
}

// A constant expression must not overflow anywhere. The compiler and a program obtain the same results.
struct outcomes {
  int regulators = 0, discrete_regulators = 0, discrete_forms = 0;
};

constexpr outcomes of_wild_numbers(int problems) {
  std::uint32_t random = 1;
  const auto wild = [&](int decades) {
    random = random * 1664525u + 1013904223u;
    if (random % 1024 < 150) return 0.0;
    double x = 1 + (random >> 16) / 65536.0;
    random = random * 1664525u + 1013904223u;
    for (auto k = (random >> 16) % static_cast<unsigned>(decades); k > 0; --k)
      x *= random % 2048 < 1024 ? 10 : 0.1;
    random = random * 1664525u + 1013904223u;
    return random >> 31 == 0 ? x : -x;
  };
  outcomes found;
  for (int k = 0; k < problems; ++k) {
    const int decades = k % 3 == 0 ? 300 : k % 3 == 1 ? 30 : 3;
    square<double, 2> a, q;
    column<double, 2> b;
    for (double& each : a.entries) each = wild(decades);
    for (double& each : b.entries) each = wild(decades);
    for (int i = 0; i < 2; ++i) q(i, i) = wild(decades), q(i, i) *= q(i, i) < 0 ? -1 : 1;
    const double r = wild(decades), h = wild(decades);
    found.regulators += lqr(a, b, q, {r < 0 ? -r : r + 1e-300}) ? 1 : 0;
    found.discrete_regulators += dlqr(a, b, q, {r < 0 ? -r : r + 1e-300}) ? 1 : 0;
    found.discrete_forms += discretize(a, b, h) ? 1 : 0;
  }
  return found;
}
constexpr outcomes by_the_compiler = of_wild_numbers(30);

TEST(extreme_numbers, are_taken_by_constant_expressions) {
  const outcomes by_the_program = of_wild_numbers(30);
  EXPECT_EQ(by_the_compiler.regulators, by_the_program.regulators);
  EXPECT_EQ(by_the_compiler.discrete_regulators, by_the_program.discrete_regulators);
  EXPECT_EQ(by_the_compiler.discrete_forms, by_the_program.discrete_forms);
  EXPECT_GT(by_the_program.regulators, 10);
  EXPECT_GT(by_the_program.discrete_regulators, 5);
  EXPECT_GT(by_the_program.discrete_forms, 10);
}

constexpr auto long_way =
    discretize(numeric::by_rows({{0.0, 1e200}, {0.0, 0.0}}), column<double, 2>{{0, 1}}, 0.01);

TEST(discretize_of_extreme_numbers, is_right_where_its_result_is_a_number) {
  static_assert(long_way);
  EXPECT_NEAR(long_way.A(0, 1), 1e198, 1e183);
  EXPECT_EQ(long_way.A(0, 0), 1);
  EXPECT_EQ(long_way.A(1, 0), 0);
  EXPECT_NEAR(long_way.B(0), 5e195, 1e180);
  EXPECT_NEAR(long_way.B(1), 0.01, 1e-17);

  const auto single =
      discretize(numeric::by_rows({{0.0f, 1e30f}, {0.0f, 0.0f}}), column<float, 2>{{0, 1}}, 0.01f);
  ASSERT_TRUE(single) << single.status;
  EXPECT_NEAR(single.A(0, 1) / 1e28f, 1, 1e-6);

  // A chain, and motions that decay instantly.
  const auto chain = discretize(numeric::by_rows({{0.0, 1e200, 0.0}, {0.0, 0.0, 1e-200}, {0.0, 0.0, 0.0}}),
                                column<double, 3>{{0, 0, 1}}, 2.0);
  ASSERT_TRUE(chain) << chain.status;
  EXPECT_NEAR(chain.A(0, 1) / 2e200, 1, 1e-14);
  EXPECT_NEAR(chain.A(0, 2), 2, 1e-14);
  EXPECT_NEAR(chain.B(0), 4.0 / 3, 1e-14);
  const auto decays =
      discretize(numeric::by_rows({{-1e300, 0.0}, {0.0, 0.0}}), column<double, 2>{{1e300, 1}}, 1e200);
  ASSERT_TRUE(decays) << decays.status;
  EXPECT_EQ(decays.A(0, 0), 0);
  EXPECT_NEAR(decays.B(0), 1, 1e-14);
  EXPECT_NEAR(decays.B(1), 1e200, 1e185);
}

TEST(discretize_of_extreme_numbers, says_what_is_too_large) {
  EXPECT_EQ(discretize(numeric::by_rows({{1e200, 1e200}, {0.0, 0.0}}), column<double, 2>{{0, 1}}, 0.01)
                .status.cause(),
            too_far);
  EXPECT_EQ(discretize(numeric::by_rows({{0.0, 1e200}, {0.0, 0.0}}), column<double, 2>{{0, 1e200}}, 0.01)
                .status.cause(),
            too_far);
}

} // namespace
