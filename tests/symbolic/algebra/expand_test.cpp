// builds: clang++ sanitize
#include "symbolic/algebra/rewritten_formulas.hpp"

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class expanded : public testing::Test, protected symbols {
protected:
  static std::string text(expression e) {
    const rewritten sum = expand(e);
    EXPECT_TRUE(sum) << sum.cause;
    return print(sum);
  }
};

TEST_F(expanded, products_are_sums) {
  EXPECT_EQ(text((a + b) * (a - b)), "a^2 - b^2");
  EXPECT_EQ(text((x + 1) * (x + 1) * (x - 2)), "x^3 - 3*x - 2");
  EXPECT_EQ(text(m * (r * (a + b) - r * a) - m * r * b), "0");
  EXPECT_EQ(text((a + b) * (a + b) / (a * b)), "a/b + b/a + 2");
  EXPECT_EQ(text(fraction(1, 3) * (6 * (a + fraction(1, 2)))), "2*a + 1");
}

TEST_F(expanded, sums_under_a_bar_stay) {
  EXPECT_EQ(text((a + b) / (c * (x + y))), "a/(c*(x + y)) + b/(c*(x + y))");
  EXPECT_EQ(text(1 / (a * b - a * c)), "1/(a*(b - c))");
  EXPECT_EQ(text(x / (1 / (a + b))), "a*x + b*x");
  EXPECT_EQ(text((a + x / (a + b)) / (1 / (a + b))), "a^2 + a*b + x");
  EXPECT_EQ(text(x / (a - b) + x / (b - a)), "0");
  EXPECT_EQ(text((a + b) / number(0)), "(a + b)/0");
}

TEST_F(expanded, arguments_too) {
  EXPECT_EQ(text(sin((a + b) * x)), "sin(a*x + b*x)");
  EXPECT_EQ(text(sin(-(q1 + q2 - u1)) + sin(q1 - (u1 - q2))), "0");
  EXPECT_EQ(text(cos(q2 * (q1 - 1)) - cos(q2 - q1 * q2)), "0");
  EXPECT_EQ(text(power(x * (a + b), a * (b - 1))), "(a*x + b*x)^(a*b - a)");
  EXPECT_EQ(text(atan2(x * (a + 1), -(x * (b + 1)))), "atan2(a*x + x, -b*x - x)");
}

TEST_F(expanded, squares_of_roots_vanish) {
  EXPECT_EQ(text(sqrt(a + b) * (sqrt(a + b) + x) * sqrt(a + b)), "a*x + a*sqrt(a + b) + b*x + b*sqrt(a + b)");
  EXPECT_EQ(text((sqrt(x) + 1) * (sqrt(x) - 1)), "x - 1");
  EXPECT_EQ(text((1 / sqrt(x * y)) * (1 / sqrt(x * y))), "1/(x*y)");
}

TEST_F(expanded, decimal_numbers_stay_decimal) {
  EXPECT_EQ(text(number(9.81) * (a + b) / 2), "4.905*a + 4.905*b");
  EXPECT_EQ(text((x + number(0.1)) * (3 * x - 1)), "3*x^2 - 0.7*x - 0.1");
  EXPECT_EQ(text(number(0.1) * (a + 3) / number(0.1)), "a + 3");
}

TEST_F(expanded, numbers_do_not_overflow_on_the_way) {
  const expression large = constant(g, exactly(4'000'000'007));
  const expression p = large * x + y, q = large * x - y;
  EXPECT_EQ(text(p * p * (q * q) - p * q * (q * p) + a), "a"); // coefficients up to 2.56e38
  EXPECT_EQ(text(p * p * p - q * q * q - 2 * (y * y * y)),
            "96000000336000008192*x^2*y"); // ...0294, rounded once
}

TEST_F(expanded, small_systems_are_written_out_and_large_ones_symbols) {
  matrix two(g, 2, 2);
  two(0, 0) = a, two(0, 1) = b, two(1, 0) = b, two(1, 1) = c;
  const expression small = solve(factorization(g, two), {x, y})[0];
  EXPECT_EQ(text((a * c - b * b) * small - c * x), text(-b * y));
  matrix four(g, 4, 4);
  for (int i = 0; i < 4; ++i) four(i, i) = x + i, four(i, (i + 1) % 4) = y;
  const expression large = solve(factorization(g, four), {a, b, c, m})[2];
  EXPECT_EQ(expand(large * (a + b)).value, a * large + b * large);
}

TEST_F(expanded, shared_parts_are_not_repeated) {
  expression sum = a, before = b;
  for (int i = 0; i < 60; ++i) {
    const expression next = sum + before;
    before = sum;
    sum = next;
  }
  EXPECT_EQ(text(sum * x), "2504730781961*a*x + 1548008755920*b*x");
  expression p = a * b;
  for (int i = 0; i < 20; ++i) p *= p;
  EXPECT_EQ(text(p * p), "a^2097152*b^2097152");
  for (int i = 0; i < 60; ++i) p *= p;
  EXPECT_EQ(expand(p).cause, "the expression cannot be multiplied out: an exponent is too large");
}

TEST_F(expanded, too_many_terms_are_reported) {
  expression p = a + b + c;
  for (const expression& other : {x, y, z, q1, q2}) p *= a + b + c + other;
  const std::size_t terms = 3 + 3 * 5; // far fewer than there are
  const rewritten none = expand(p, terms);
  EXPECT_FALSE(none);
  EXPECT_EQ(none.value, p);
  EXPECT_EQ(none.cause, "the expression cannot be multiplied out: the sums have more than 18 terms");
  EXPECT_TRUE(expand(p));
  expression power = a + b;
  for (int i = 0; i < 60; ++i) power *= power + c;
  EXPECT_EQ(expand(power).value, power);
  EXPECT_FALSE(expand(power));
  EXPECT_EQ(expand(0 * power + a).value, a);
}

TEST(random_formula, is_the_same_when_expanded) {
  int done = 0;
  expect_same_values([](expression e) { return expand(e, 2000); }, 40, done);
  EXPECT_GT(done, 1150);
}

} // namespace
