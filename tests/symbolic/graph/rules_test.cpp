// builds: clang++ sanitize
#include "symbolic/random_formula.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::evaluate;

class rules : public testing::Test, protected symbols {};

TEST_F(rules, keep_the_value_of_random_formulas) {
  int well_conditioned = 0, compared = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 100; ++i) {
      const random_formulas::formula f = random.make(1 + i % 5);
      for (std::size_t p = 0; p < random_formulas::points; ++p) {
        const long double value = f.value[p], simplified = evaluate(f.e, random.point(p));
        ASSERT_LE(std::abs(simplified - value), 1e-12L * std::abs(value) + 32 * f.error[p])
            << seed << ' ' << i;
        well_conditioned += f.error[p] <= 1e-13L * std::abs(value) ? 1 : 0;
        ++compared;
      }
    }
  }
  EXPECT_GT(well_conditioned, compared * 9 / 10);
}

TEST_F(rules, never_make_a_formula_longer) {
  for (unsigned seed = 100; seed < 130; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 100; ++i) {
      const random_formulas::formula f = random.make(1 + i % 5);
      const cost made = cost_of(s.g, {f.e.node()});
      const int operations =
          made.additions + made.multiplications + made.divisions + made.trigonometric + made.other;
      ASSERT_LE(operations, f.operations) << seed << ' ' << i;
    }
  }
}

TEST_F(rules, are_exact_in_fractions) {
  symbols s;
  std::mt19937 engine(3);
  for (int i = 0; i < 2000; ++i) {
    // c1 x + c2 x - c3 x - (c1 + c2 - c3) x in fractions that no double holds
    const auto pick = [&] {
      return s.fraction(static_cast<int>(engine() % 61) - 30, 1 + static_cast<int>(engine() % 97));
    };
    const expression c1 = pick(), c2 = pick(), c3 = pick();
    EXPECT_EQ(c1 * s.x + c2 * s.x - c3 * s.x, (c1 + c2 - c3) * s.x);
    if (!c3.is_zero()) {
      EXPECT_EQ((c1 * s.x) / c3, (c1 / c3) * s.x);
    }
  }
}

TEST_F(rules, meet_in_one_node_whatever_the_order) {
  EXPECT_EQ(a + b, b + a);
  EXPECT_EQ(a * b, b * a);
  EXPECT_EQ(a - b, -(b - a));
  EXPECT_EQ((a + b) - b, a);
  EXPECT_EQ(a - (a - b), b);
  EXPECT_EQ((-a) * b, -(a * b));
  EXPECT_EQ(a * (-b), -(a * b));
  EXPECT_EQ(a / -b, -(a / b));
  EXPECT_EQ((2 * a) * (3 * b), 6 * (a * b));
  EXPECT_EQ((a + 1) + (b + 2), (b + a) + 3);
}

TEST_F(rules, know_zeros_ones_and_signs) {
  const expression zero = number(0), one = number(1);
  EXPECT_EQ(a + zero, a);
  EXPECT_EQ(a - a, zero);
  EXPECT_EQ(zero * a, zero);
  EXPECT_EQ(one * a, a);
  EXPECT_EQ(a / a, one);
  EXPECT_EQ(zero / a, zero);
  EXPECT_EQ(-(-a), a);
  EXPECT_EQ(a + a, 2 * a);
  EXPECT_EQ(3 * a - 2 * a, a);
  EXPECT_EQ((a / b) * b, a);
  EXPECT_EQ((a * b) / b, a);
  EXPECT_EQ((a * b) / a, b);
  EXPECT_EQ((a - b) - a, -b);
  EXPECT_EQ(a - (a + b), -b);
  EXPECT_EQ(a / 4, fraction(1, 4) * a);
  EXPECT_EQ(sqrt(a) * sqrt(a), a);
  EXPECT_EQ(a / sqrt(a), sqrt(a));
}

TEST_F(rules, know_functions) {
  EXPECT_EQ(sin(q1) * sin(q1) + cos(q1) * cos(q1), number(1));
  EXPECT_EQ(sin(-q1), -sin(q1));
  EXPECT_EQ(cos(-q1), cos(q1));
  EXPECT_EQ(atan(-q1), -atan(q1));
  EXPECT_EQ(sinh(-q1), -sinh(q1));
  EXPECT_EQ(cosh(-q1), cosh(q1));
  EXPECT_EQ(tanh(-q1), -tanh(q1));
  EXPECT_EQ(abs(-q1), abs(q1));
  EXPECT_EQ(abs(abs(q1)), abs(q1));
  EXPECT_EQ(sqrt(fraction(9, 4)), fraction(3, 2));
  EXPECT_EQ(sin(number(0)), number(0));
  EXPECT_EQ(cos(number(0)), number(1));
  EXPECT_EQ(power(a, number(3)), a * (a * a));
  EXPECT_EQ(power(a, number(0)), number(1));
  EXPECT_EQ(power(number(1), a), number(1));
  EXPECT_EQ(power(a, number(0.5)), sqrt(a));
  EXPECT_EQ(power(a, fraction(-1, 2)), 1 / sqrt(a));
}

TEST_F(rules, leave_a_division_by_zero_to_be_reported) {
  const expression e = a / number(0);
  EXPECT_EQ(g[e.node()].op, operation::divide);
}

TEST_F(rules, hold_while_the_table_grows) {
  sequence<expression> made;
  expression e = a;
  for (int i = 0; i < 5000; ++i) made.push(e = sin(e) + number(i + 0.5));
  const int size = g.size();
  e = a;
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(e = sin(e) + number(i + 0.5), made[i]);
  EXPECT_EQ(g.size(), size);
}

/// The last node and the size of a graph that outgrows its table, after some of it has been forgotten.
constexpr std::pair<int, int> grown() {
  graph g;
  const int x = g.find_or_append({operation::symbol, 0, 0});
  int sum = x, kept = x;
  for (int i = 0; i < 300; ++i) sum = add(g, multiply(g, sum, x), g.constant(exactly(i + 2)));
  const graph::extent before = g.present();
  for (int i = 0; i < 50; ++i) kept = multiply(g, kept, sum);
  g.forget_after(before);
  return {multiply(g, x, sum), g.size()};
}

TEST_F(rules, hold_while_the_table_grows_in_a_constant_expression) {
  constexpr std::pair<int, int> at_compile_time = grown();
  EXPECT_EQ(grown(), at_compile_time);
  EXPECT_GT(at_compile_time.second, 512);
}

} // namespace
