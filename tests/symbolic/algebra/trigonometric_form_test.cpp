// builds: clang++ sanitize
#include "scrambled_formula.hpp"
#include "symbolic/algebra/rewritten_formulas.hpp"

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;

class trigonometric_form : public testing::Test, protected symbols {
protected:
  static std::string text(expression e) {
    const rewritten form = trigonometric_normal_form(e);
    EXPECT_TRUE(form) << form.cause;
    return print(form);
  }
};

TEST_F(trigonometric_form, has_one_sine_or_cosine_in_each_term) {
  EXPECT_EQ(text(sin(q1) * sin(q1)), "1/2 - cos(2*q1)/2");
  EXPECT_EQ(text(sin(q1) * cos(q1) * m), "m*sin(2*q1)/2");
  EXPECT_EQ(text(sin(q1) * cos(q2)), "sin(q1 - q2)/2 + sin(q1 + q2)/2");
  EXPECT_EQ(text(a * (sin(q1) * sin(q1 + q2) + cos(q1) * cos(q1 + q2))), "a*cos(q2)");
  EXPECT_EQ(text(u1 * u1 * sin(q2 - q1) + x * sin(q1 - q2)), "x*sin(q1 - q2) - u1^2*sin(q1 - q2)");
}

TEST_F(trigonometric_form, knows_the_theorems) {
  EXPECT_EQ(text(sin(q1) * sin(q1) * a + cos(q1) * cos(q1) * a), "a");
  EXPECT_EQ(text(sin(q1 + q2) - sin(q1) * cos(q2) - cos(q1) * sin(q2)), "0");
  EXPECT_EQ(text(cos(2 * q1) + 2 * (sin(q1) * sin(q1))), "1");
  EXPECT_EQ(text(sin(3 * q1) + 4 * (sin(q1) * sin(q1) * sin(q1))), "3*sin(q1)");
  EXPECT_EQ(text(2 * (sin(q1 / 2) * cos(q1 / 2))), "sin(q1)");
  EXPECT_EQ(text(cos(x * a + u1 / y) + cos(x * a - u1 / y)), "cos(a*x - u1/y) + cos(a*x + u1/y)");
  EXPECT_EQ(text(cos(x * a + u1 / y) + cos(x * a - u1 / y) - 2 * (cos(a * x) * cos(u1 / y))), "0");
}

TEST_F(trigonometric_form, tangents_are_quotients) {
  EXPECT_EQ(text(tan(q1) * cos(q1)), "sin(q1)");
  EXPECT_EQ(text(tan(q1) / sin(q1)), "1/cos(q1)");
  EXPECT_EQ(text(tan(q1) * tan(q1) + 1), "1/cos(q1)^2");
  EXPECT_EQ(text((tan(q1) + tan(q2)) / (1 - tan(q1) * tan(q2))), "sin(q1 + q2)/cos(q1 + q2)");
  EXPECT_EQ(text(sin(2 * q1) / cos(q1)), "2*sin(q1)");
  EXPECT_EQ(text((1 - cos(q1)) * (cos(q1) + 1) / sin(q1)), "sin(q1)");
}

TEST_F(trigonometric_form, takes_other_functions_for_symbols) {
  EXPECT_EQ(text(exp(x * (a + b)) - exp(a * x + b * x)), "0");
  EXPECT_EQ(text(exp(sin(x) * sin(x) + cos(x) * cos(x))), print(exp(number(1))));
  EXPECT_EQ(text(sin(atan2(y, x) + q1) - sin(q1) * cos(atan2(y, x))),
            "sin(q1 + atan2(y, x))/2 - sin(q1 - atan2(y, x))/2");
  EXPECT_EQ(text(sin(sin(q1) * sin(q1)) - sin(1 - cos(q1) * cos(q1))), "0");
  EXPECT_EQ(text(cos(x / (a + b)) - cos(-(x / (b + a)))), "0");
}

TEST_F(trigonometric_form, takes_decimal_numbers_for_what_their_bits_say) {
  EXPECT_EQ(text(number(9.81) * m * cos(q1) * cos(q1)), "4.905*m + 4.905*m*cos(2*q1)");
  EXPECT_EQ(text(number(0.5) * cos(q1) - cos(q1) / 2), "0");
  EXPECT_NE(text(number(0.1) * cos(q1)), text(cos(q1) / 10));
  EXPECT_EQ(text(2 * (sin(number(0.1) * q1) * cos(number(0.1) * q1))), "sin(0.2*q1)");
  EXPECT_EQ(text(sin(q1 + number(0.7)) - sin(number(0.7) + q1)), "0");
}

TEST_F(trigonometric_form, too_many_terms_are_reported) {
  expression e = sin(q1) + a;
  for (int i = 0; i < 12; ++i) e *= e + sin(q2 + (i + 1) * q1);
  const rewritten same = trigonometric_normal_form(e);
  EXPECT_FALSE(same);
  EXPECT_EQ(same.value, e);
  EXPECT_EQ(same.cause.substr(0, 48), "the expression has no trigonometric normal form:");
  const expression zero = sin(q1) * sin(q1) + 0 * cos(q1) - (1 - cos(q1) * cos(q1));
  EXPECT_EQ(
      trigonometric_normal_form(x / zero).cause,
      "the expression has no trigonometric normal form: it divides by an expression that is zero everywhere");
}

TEST(scrambled_polynomial, has_the_same_node) {
  int different = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    symbols s;
    scrambled_formulas random(s, seed, false);
    const scrambled_formulas::pair p = random.make(4);
    const rewritten first = trigonometric_normal_form(p.first), second = trigonometric_normal_form(p.second);
    ASSERT_TRUE(first && second) << seed << first.cause;
    EXPECT_EQ(first.value, second.value) << seed << ": " << print(p.first) << "\n" << print(p.second);
    EXPECT_EQ(trigonometric_normal_form(first).value, first.value);
    different += p.first == p.second ? 0 : 1;
    for (const std::vector<long double>& at : random.points()) {
      const long double value = evaluate(p.first, at);
      EXPECT_PRED3(are_close, evaluate(first.value, at), value, 1e-12L * (1 + std::abs(value))) << seed;
    }
  }
  EXPECT_GT(different, 250);
}

TEST(random_formula, is_the_same_in_trigonometric_form) {
  int done = 0;
  expect_same_values([](expression e) { return trigonometric_normal_form(e, 500); }, 30, done);
  EXPECT_GT(done, 800);
}

} // namespace
