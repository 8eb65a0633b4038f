// builds: clang++ sanitize
#include "symbolic/algebra/rewritten_formulas.hpp"

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class cancelled : public testing::Test, protected symbols {
protected:
  static std::string text(expression e) {
    const rewritten quotient = cancel(e);
    EXPECT_TRUE(quotient) << quotient.cause;
    return print(quotient);
  }
};

TEST_F(cancelled, monomials) {
  EXPECT_EQ(text(-(a * r * m) / (r * r * m)), "-a/r");
  EXPECT_EQ(text(a / (b / (c / m))), "a*c/(b*m)");
  EXPECT_EQ(text(6 * x / (4 * y)), "3*x/(2*y)");
  EXPECT_EQ(text(a / 3 / (c / 2 + b / 5)), "10*a/(3*(2*b + 5*c))");
}

TEST_F(cancelled, common_factors) {
  EXPECT_EQ(text((a * a - b * b) / (a - b)), "a + b");
  EXPECT_EQ(text((a * a - b * b) / (b - a)), "-a - b");
  EXPECT_EQ(text((x * x + 2 * x + 1) / (x * x - 1)), "(x + 1)/(x - 1)");
  EXPECT_EQ(text((a + b) * (a - b) * (x + y) / ((a + b) * (c + x) * (y + x))), "(a - b)/(c + x)");
  EXPECT_EQ(text((x * x * x - y * y * y) / (x * x * x * x - y * y * y * y)),
            "(x^2 + x*y + y^2)/(x^3 + x^2*y + x*y^2 + y^3)");
}

TEST_F(cancelled, sums_of_quotients) {
  EXPECT_EQ(text(1 / (a - b) + 1 / (a + b)), "2*a/((a - b)*(a + b))");
  EXPECT_EQ(text(1 / (a - b) + 1 / (b - a)), "0");
  EXPECT_EQ(text(a / (b / (c / (x + 1) + 1) + 1)), "a*(c + x + 1)/(b + b*x + c + x + 1)");
  EXPECT_EQ(text(x / (a * b) + y / (a * c)), "(b*y + c*x)/(a*b*c)");
  EXPECT_EQ(text(x - x * x / (x + y)), "x*y/(x + y)");
}

TEST_F(cancelled, what_all_terms_share_stands_in_front) {
  EXPECT_EQ(text(a * r - m * r), "r*(a - m)");
  EXPECT_EQ(text(-a * a - a * b), "-a*(a + b)");
  EXPECT_EQ(text(-(a * (m + b)) / (b * r)), "-a*(b + m)/(b*r)");
  EXPECT_EQ(text((x / 2 + y / 3) / c), "(3*x + 2*y)/(6*c)");
}

TEST_F(cancelled, functions_are_symbols) {
  EXPECT_EQ(text((1 - cos(q1) * cos(q1)) / (cos(q1) - 1)), "-cos(q1) - 1");
  EXPECT_EQ(text(sin(a * b / b) / sin(a) + x / y), "(x + y)/y");
  EXPECT_EQ(text(sin((a - b) / (b - a) * q1) / sin(q1)), "-1");
  EXPECT_EQ(text(abs(b - a) / abs(a - b)), "1");
}

TEST_F(cancelled, squares_of_roots_vanish) {
  EXPECT_EQ(text(sqrt(x) * sqrt(x) * y / (x * x)), "y/x");
  EXPECT_EQ(text(x / sqrt(x) - sqrt(x)), "0");
  EXPECT_EQ(text((sqrt(a / m) * r) * (sqrt(a / m) * r)), "a*r^2/m");
}

TEST_F(cancelled, decimal_numbers_stay_as_they_are) {
  EXPECT_EQ(text((number(9.81) * a + number(0.1) * b) / (number(9.81) * c * a + number(0.1) * b * c)), "1/c");
  EXPECT_EQ(text(a / (number(9.81) * c + number(0.1) * b)), "a/(0.1*b + 9.81*c)");
  EXPECT_EQ(text(-(number(9.81) * m * r) / (m * r * r)), "-9.81/r");
}

TEST_F(cancelled, the_linearization_of_a_pendulum_is_that_of_the_textbook) {
  const expression gravity = of(kind::parameter, "g"), length = of(kind::parameter, "l");
  const sequence<expression> state{q1, u1};
  const sequence<expression> rates{u1, -(gravity * length * m * sin(q1)) / (length * length * m)};
  substitution at_rest(g);
  for (const expression& each : state) at_rest.replace(each, number(0));
  matrix linear(g, 2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) linear(i, j) = cancel(at_rest.in(differentiate(rates[i], state[j])));
  EXPECT_EQ(print(linear), "[0,    1]\n"
                           "[-g/l, 0]");
}

TEST_F(cancelled, dividing_by_nothing_is_reported) {
  const expression e = x / ((a + b) * (a - b) - a * a + b * b);
  const rewritten same = cancel(e);
  EXPECT_FALSE(same);
  EXPECT_EQ(same.value, e);
  EXPECT_EQ(same.cause,
            "the expression cannot be cancelled: it divides by an expression that is zero everywhere");
}

TEST_F(cancelled, too_many_terms_are_reported) {
  expression e = a / b + x;
  for (int i = 0; i < 12; ++i) e *= e + c / (e + y);
  EXPECT_EQ(cancel(e).value, e);
  EXPECT_EQ(cancel(e).cause.substr(0, 36), "the expression cannot be cancelled: ");
  EXPECT_FALSE(cancel((a + b + c) * (x + y + z), 8));
  EXPECT_TRUE(cancel((a + b + c) * (x + y + z), 9));
}

TEST(random_formula, is_the_same_when_cancelled) {
  int done = 0;
  expect_same_values([](expression e) { return cancel(e, 500); }, 40, done);
  EXPECT_GT(done, 1100);
}

/// Sums of a few products of powers with small integer coefficients.
expression random_sum(symbols& s, std::mt19937& random) {
  const expression all[] = {s.a, s.b, s.x, s.y, s.q1};
  expression sum = s.number(0);
  for (int i = 0; i < 4; ++i) {
    expression product = s.number(static_cast<double>(random() % 9) - 4);
    for (int j = 0; j < 3; ++j) product *= random() % 2 == 0 ? all[random() % 5] : s.number(1);
    sum += product;
  }
  return sum + s.c; // never zero
}

TEST(random_fractions, lose_all_common_factors) {
  symbols s;
  std::mt19937 random(1);
  for (int i = 0; i < 150; ++i) {
    const expression p = random_sum(s, random), q = random_sum(s, random), f = random_sum(s, random);
    const rewritten lowest = cancel(p * q / (q * f * q));
    ASSERT_TRUE(lowest) << lowest.cause;
    EXPECT_EQ(lowest.value, cancel(p * f / (f * f * q)).value) << print(lowest);
    EXPECT_EQ(cancel(lowest.value - p / (q * f)).value, s.number(0));
    EXPECT_EQ(cancel(p * q * f / (expand(f * p))).value, cancel(expand(q)).value);
  }
}

} // namespace
