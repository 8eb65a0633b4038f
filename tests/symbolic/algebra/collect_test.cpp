// builds: clang++ sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/term.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;

class collected : public testing::Test, protected symbols {
protected:
  static std::string text(expression e, const sequence<expression>& by) {
    const rewritten sum = collect(e, by);
    EXPECT_TRUE(sum) << sum.cause;
    return print(sum);
  }
};

TEST_F(collected, by_powers_of_a_symbol) {
  EXPECT_EQ(text(a * x + b * x - c * x * x + x * x * y - c, {x}), "x^2*(y - c) - c + x*(a + b)");
  EXPECT_EQ(text((x + 1) * (x + 1) * (x - a), {x}), "x^3 - a + x^2*(2 - a) + x*(1 - 2*a)");
  EXPECT_EQ(text(m * (x + y) - m * x, {x}), "m*y");
  EXPECT_EQ(text(-a * x - b * x, {x}), "-x*(a + b)");
  EXPECT_EQ(text(a / x + b / x + c / (x * x), {x}), "c/x^2 + (a + b)/x");
}

TEST_F(collected, by_several_symbols) {
  EXPECT_EQ(text((a * u1 + b * u2) * (m * u1 + r * u2), {u1, u2}), "a*m*u1^2 + b*r*u2^2 + u1*u2*(a*r + b*m)");
  EXPECT_EQ(text((a + b) * (x + y) + c * (x - y), {x, y}), "x*(a + b + c) + y*(a + b - c)");
}

TEST_F(collected, by_functions) {
  const expression s = sin(q1), c1 = cos(q1);
  EXPECT_EQ(text(m * (a * s + r * c1) + b * (s - c1) * s, {s, c1}),
            "a*m*sin(q1) + b*sin(q1)^2 - b*sin(q1)*cos(q1) + m*r*cos(q1)");
  EXPECT_EQ(text((a + x) * sin(q1 * (a + 1)) + b * sin(a * q1 + q1), {sin(q1 * (a + 1))}),
            "sin(a*q1 + q1)*(a + b + x)");
  EXPECT_EQ(text(x * s + y * sin(-q1) + x, {sin(-q1)}), "x + sin(q1)*(x - y)");
}

TEST_F(collected, not_under_a_bar) {
  EXPECT_EQ(text(x / (x + a) + b / (x + a) + x * x, {x}), "b/(a + x) + x^2 + x/(a + x)");
}

TEST_F(collected, by_sums_is_refused) {
  const expression e = (a + b) * (c + x);
  for (const expression& by : {a + b, a * b, a * a, number(2)}) {
    const rewritten same = collect(e, {by});
    EXPECT_FALSE(same);
    EXPECT_EQ(same.value, e);
    EXPECT_EQ(
        same.cause,
        "an expression can be collected only by symbols and functions, not by sums, products or powers");
  }
}

TEST_F(collected, too_many_terms_are_reported) {
  expression e = x + a;
  for (int i = 0; i < 12; ++i) e *= e + b;
  const rewritten same = collect(e, {x});
  EXPECT_FALSE(same);
  EXPECT_EQ(same.value, e);
  EXPECT_EQ(same.cause.substr(0, 40), "the expression cannot be multiplied out:");
}

/// Each power of x occurs once, and its coefficient does not contain x.
int powers_of(const graph& g, expression e, expression x) {
  printing::term_reader reader(g);
  int found = 0;
  for (const printing::term& t : reader.terms_of(e.node()))
    for (const printing::factor& f : t.factors)
      if (f.base == x.node()) ++found;
  return found;
}

TEST(random_formula, is_the_same_when_collected) {
  int done = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 30; ++i) {
      const random_formulas::formula f = random.make(1 + i % 5), h = random.make(2);
      const expression cubic = (s.x * f.e + h.e) * (s.x * s.x - f.e) + s.x * h.e;
      const rewritten sum = collect(cubic, {s.x}, 2000);
      if (!sum) continue;
      ++done;
      EXPECT_LE(powers_of(s.g, sum, s.x), 3);
      const std::vector<long double>& at = random.point(0);
      const long double value = evaluate(cubic, at);
      const long double size = 1 + std::abs(f.value[0]) + std::abs(h.value[0]);
      const long double tolerance = size * (1e-12L * size + 1e4L * (f.error[0] + h.error[0]));
      ASSERT_PRED3(are_close, evaluate(sum.value, at), value, tolerance) << seed << ' ' << i;
    }
  }
  EXPECT_GT(done, 850);
}

} // namespace
