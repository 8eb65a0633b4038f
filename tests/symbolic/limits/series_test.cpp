// builds: clang++ sanitize
#include "../symbols.hpp"

#include "evaluate_graph.hpp"

#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/limits/operation_series.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr::symbolic;
using namespace kanexpr::symbolic::limits;
using graph_evaluation::are_close;
using graph_evaluation::arithmetic;
using real = long double;

constexpr int most = 12;
constexpr real step = 1 / 64.0L; // the omitted terms are about step^13

/// A polynomial in ε with random terms from a given order on, the first of a given sign, and its value.
struct random_polynomial {
  random_polynomial(std::mt19937& engine, int first, int count, double sign) {
    std::uniform_real_distribution<double> uniform(0.3, 0.8);
    std::vector<coefficient> terms;
    for (int k = 0; k < count; ++k) {
      const double c = k == 0 ? sign * uniform(engine) : uniform(engine) - 0.5;
      terms.emplace_back(kanexpr::symbolic::real(c));
      value += c * std::pow(step, static_cast<real>(first + k));
    }
    s = series(first, terms, series::all_orders, most);
  }
  series s;
  real value = 0;
};

real value_of_series(const series& s) {
  real sum = 0;
  for (int k = s.order(); k < s.nonzero_end(); ++k) {
    EXPECT_TRUE(s[k].is_number());
    sum += s[k].value().value() * std::pow(step, static_cast<real>(k));
  }
  return sum;
}

/// Compares with an evaluation at a small ε, up to the unknown terms.
void check(operation op, const series& a, const series& b, real x, real y) {
  const expansion found = apply(op, a, b);
  ASSERT_TRUE(found) << function_name(op) << ' ' << static_cast<int>(found.reason());
  const real expected = arithmetic(op, x, y);
  const real unknown =
      found->end() == series::all_orders ? 0 : 100 * std::pow(step, static_cast<real>(found->end()));
  EXPECT_PRED3(are_close, value_of_series(*found), expected, 1e-14L * std::abs(expected) + unknown)
      << static_cast<int>(op) << " known to " << found->end();
}

TEST(series, calculate_as_the_functions_that_they_stand_for) {
  std::mt19937 engine(1);
  for (int i = 0; i < 40; ++i)
    for (const int first : {0, 1, -1, 2}) {
      const random_polynomial a(engine, first, 1 + i % 4, 1), b(engine, i % 4 - 1, 1 + i % 3, -1);
      for (const operation op : {operation::add, operation::subtract, operation::multiply, operation::divide})
        check(op, a.s, b.s, a.value, b.value);
      check(operation::multiply, *quotient(a.s, b.s), b.s, a.value / b.value, b.value);
    }
}

TEST(series, have_functions) {
  std::mt19937 engine(2);
  constexpr operation entire[] = {operation::sin,  operation::cos,       operation::tan, operation::asin,
                                  operation::acos, operation::atan,      operation::exp, operation::sinh,
                                  operation::cosh, operation::tanh,      operation::abs, operation::sign,
                                  operation::erf,  operation::wrap_to_pi};
  for (int i = 0; i < 20; ++i) {
    for (const int first : {0, 1, 2})
      for (const operation op : entire) {
        const random_polynomial a(engine, first, 1 + i % 4, i % 2 == 0 ? 1 : -1);
        check(op, a.s, {}, a.value, 0);
      }
    const random_polynomial base(engine, 0, 2 + i % 3, 1), even(engine, 2, 1 + i % 3, 1),
        any(engine, i % 2, 3, -1);
    check(operation::sqrt, base.s, {}, base.value, 0);
    check(operation::sqrt, even.s, {}, even.value, 0);
    check(operation::log, base.s, {}, base.value, 0);
    const random_polynomial cubed(engine, 3, 1 + i % 3, -1);
    check(operation::cbrt, base.s, {}, base.value, 0);
    check(operation::cbrt, -base.s, {}, -base.value, 0);
    check(operation::cbrt, cubed.s, {}, cubed.value, 0);
    check(operation::atan, *quotient(base.s, even.s), {}, base.value / even.value, 0);
    check(operation::power, base.s, any.s, base.value, any.value);
    for (const number& p : {exactly(-2), exactly(3), exactly(1, 3), exactly(-5, 2)})
      check(operation::power, base.s, series(coefficient(p)), base.value,
            static_cast<real>(p.numerator) / static_cast<real>(p.denominator));
    for (const random_polynomial* x : {&base, &even, &any}) {
      check(operation::atan2, any.s, x->s, any.value, x->value);
      check(operation::atan2, base.s, x->s, base.value, x->value);
      check(operation::atan2, even.s, x->s, even.value, x->value);
      check(operation::if_positive, any.s, x->s, any.value, x->value);
      check(operation::if_not_positive, any.s, x->s, any.value, x->value);
      check(operation::if_positive, even.s, x->s, even.value, x->value);
    }
  }
}

/// Functions of two arguments that have no separate series use the one that follows from their slopes.
TEST(series, follow_from_two_slopes) {
  std::mt19937 engine(4);
  for (int i = 0; i < 20; ++i) {
    const random_polynomial y(engine, i % 3, 1 + i % 4, 1), x(engine, 0, 1 + i % 3, i % 2 == 0 ? 1 : -1);
    const expansion found = smooth(operation::atan2, y.s, x.s), expected = apply(operation::atan2, y.s, x.s);
    ASSERT_TRUE(found && expected);
    EXPECT_EQ(found->end(), expected->end());
    EXPECT_PRED3(are_close, value_of_series(*found), value_of_series(*expected), 1e-13L);
  }
}

TEST(series, jump_where_an_angle_is_wrapped) {
  const coefficient pi(kanexpr::symbolic::real(3.141592653589793));
  for (const int turns : {-3, -1, 1, 3})
    for (const int side : {-1, 1}) {
      const series e = series::linear(coefficient(turns) * pi, coefficient(side), most);
      const expansion wrapped = apply(operation::wrap_to_pi, e, {});
      ASSERT_TRUE(wrapped);
      EXPECT_EQ((*wrapped)[0].value().value(), side > 0 ? -3.141592653589793 : 3.141592653589793);
      EXPECT_EQ((*wrapped)[1].value(), exactly(side));
    }
}

TEST(series, pass_the_ends_of_an_arcsine) {
  const series gap = series(2, {coefficient(1), coefficient(2)}, series::all_orders, most);
  for (const int end : {1, -1})
    for (const operation op : {operation::asin, operation::acos}) {
      const real x = end * (1 - step * step - 2 * step * step * step);
      check(op, series(coefficient(end)) * (series(coefficient(1)) - gap), {}, x, 0);
    }
}

TEST(series, lose_no_exactness) {
  const series e = series::linear(coefficient(0), coefficient(exactly(1, 3)), 8);
  const expansion s = sine(e, operation::sin), root = sqrt(series(coefficient(exactly(4, 9))) + e);
  EXPECT_EQ((*s)[5].value(), exactly(1, 120 * 243));
  EXPECT_EQ((*s)[7].value(), exactly(-1, 5040 * 2187));
  EXPECT_EQ((*root)[0].value(), exactly(2, 3));
  EXPECT_EQ((*root)[2].value(), exactly(-3, 64)); // -ε²/(8·(2/3)³)·(1/9)
  EXPECT_TRUE((*root)[2].is_exact());
  EXPECT_TRUE((*root * *root - e - series(coefficient(exactly(4, 9)))).order() > 8);
}

TEST(series, know_how_far_they_are_known) {
  const coefficient one(1);
  const auto power_of = [&](int k) { return series(k, {one}, series::all_orders, 6); };
  EXPECT_TRUE((power_of(4) - power_of(4)).is_zero());
  EXPECT_EQ((power_of(4) * power_of(4)).end(), 7); // ε⁸ is dropped
  EXPECT_FALSE((power_of(4) * power_of(4)).is_zero());
  const series unknown(0, {one, one}, 3, 6), beyond = power_of(4) * power_of(4);
  EXPECT_EQ((unknown * power_of(2)).end(), 5);
  EXPECT_EQ((unknown / power_of(2)).end(), 1);
  EXPECT_EQ((unknown * beyond).end(), 7);
  EXPECT_EQ((power_of(2) / unknown).end(), 5);
  EXPECT_EQ(quotient(unknown, beyond).reason(), obstacle::truncated);
  EXPECT_EQ(quotient(unknown, {}).reason(), obstacle::zero_divisor);
  EXPECT_EQ(sqrt(beyond).reason(), obstacle::truncated);
  EXPECT_EQ(log(power_of(1)).reason(), obstacle::zero_logarithm);
  EXPECT_EQ(sqrt(power_of(3)).reason(), obstacle::fractional_order);
  EXPECT_EQ(sqrt(-power_of(2)).reason(), obstacle::not_real);
  EXPECT_EQ(smooth(operation::exp, power_of(-1)).reason(), obstacle::infinite_argument);
}

class coefficients : public testing::Test, protected symbols {
protected:
  coefficient of(expression e) { return {e, generic_values::of_symbol(symbol_kind::parameter, e.node())}; }
};

TEST_F(coefficients, are_zero_wherever_they_vanish) {
  const coefficient p = of(a), q = of(b);
  const coefficient difference = (p + q) * (p + q) - p * p - q * q - coefficient(2) * p * q;
  EXPECT_TRUE(difference.is_zero());
  EXPECT_FALSE((difference + p * coefficient(kanexpr::symbolic::real(1e-18))).is_zero());
  const coefficient tenth(kanexpr::symbolic::real(0.1)), fifth(kanexpr::symbolic::real(0.2)),
      rest(kanexpr::symbolic::real(0.3));
  EXPECT_TRUE((tenth + fifth - rest).is_zero());
  EXPECT_FALSE((tenth + fifth - rest + coefficient(kanexpr::symbolic::real(1e-15))).is_zero());
  EXPECT_FALSE(
      (coefficient(exactly(1, 3)) - coefficient(exactly(333333333333333333, 1000000000000000000))).is_zero());
  EXPECT_EQ((p * coefficient(6) / (q * coefficient(4))).in(g), fraction(3, 2) * (a / b));
}

TEST(rounding, stays_within_the_bound) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr operation all[] = {operation::add,    operation::subtract,    operation::multiply,
                               operation::divide, operation::sin,         operation::cos,
                               operation::tan,    operation::asin,        operation::acos,
                               operation::atan,   operation::exp,         operation::log,
                               operation::sqrt,   operation::power,       operation::atan2,
                               operation::abs,    operation::sinh,        operation::cosh,
                               operation::tanh,   operation::if_positive, operation::if_not_positive,
                               operation::cbrt,   operation::erf,         operation::wrap_to_pi};
  int count = 0, tight = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<bounded> values;
    std::vector<real> exact;
    for (int k = 0; k < 3; ++k) values.push_back({uniform(engine), 0}), exact.push_back(values.back().value);
    for (int k = 0; k < 12; ++k) {
      const std::size_t a = engine() % values.size(), b = engine() % values.size();
      const operation op = all[engine() % std::size(all)];
      const bounded next = apply(op, values[a], values[b]);
      const real expected = arithmetic(op, exact[a], exact[b]);
      if (!next.defined() || !std::isfinite(expected) || next.error > 1e-8 * std::abs(next.value)) continue;
      values.push_back(next), exact.push_back(expected);
      if (std::fpclassify(expected) == FP_ZERO)
        values.pop_back(), exact.pop_back(); // the sign of zero is not determined
      const real wrong = std::abs(next.value - expected);
      EXPECT_LE(wrong, 1.05L * next.error) << static_cast<int>(op) << ' ' << i;
      ++count, tight += wrong > next.error / 100 ? 1 : 0;
    }
  }
  EXPECT_GT(tight, count / 2);
}

} // namespace
