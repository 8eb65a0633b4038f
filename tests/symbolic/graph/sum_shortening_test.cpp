// builds: sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/graph/monomials.hpp>
#include <kanexpr/symbolic/graph/sum_shortening.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::evaluate;

class shortened_sums : public testing::Test, protected symbols {
protected:
  expression shortened(expression e) { return {g, shorten_sums(g, {e.node()}, {})[0]}; }
  expression quotient(expression above, expression below) {
    return {g, divide_in_lowest_terms(g, above.node(), below.node())};
  }
};

TEST_F(shortened_sums, sees_squares_of_sine_and_cosine) {
  const expression sine = sin(x), cosine = cos(x);
  const auto operations = [&](expression e) { return cost_of(g, {e.node()}).nodes; };
  EXPECT_EQ(operations(shortened((a * sine) * (b * (a * sine)) + (a * cosine) * (b * (a * cosine)))),
            2); // a² b
  EXPECT_EQ(operations(shortened((a * cosine) * (b * sine) - (a * sine) * (b * (y + cosine)))),
            5); // −a b sin y
  EXPECT_TRUE(shortened((a * cosine) * (b * sine) - (b * cosine) * (sine * a)).is_zero());
  EXPECT_EQ(shortened(0.3 * sine * sine + 0.3 * cosine * cosine), number(0.3));
}

TEST_F(shortened_sums, keeps_sums_that_would_not_be_shorter) {
  for (const expression e : {a * sin(x) + b * cos(x), 2 * sin(x) * sin(x) + cos(x) * cos(x), a * b + a * y})
    EXPECT_EQ(shortened(e), e);
}

TEST_F(shortened_sums, keeps_values_and_never_lengthens_a_sum) {
  int shorter = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    symbols of;
    random_formulas random(of, seed);
    for (int i = 0; i < 20; ++i) {
      const random_formulas::formula f = random.make(2 + i % 3), h = random.make(1 + i % 3);
      const expression sine = sin(of.x), cosine = cos(of.x);
      const expression first = f.e * sine * (sine * h.e) + cosine * f.e * (cosine * h.e),
                       second = sine * (f.e * (cosine + h.e)) - cosine * (sine * f.e);
      const sequence<int> before{first.node(), second.node()}, after = shorten_sums(of.g, before, {});
      const int nodes = cost_of(of.g, after).nodes;
      ASSERT_LE(nodes, cost_of(of.g, before).nodes) << seed << ' ' << i;
      shorter += nodes < cost_of(of.g, before).nodes ? 1 : 0;
      for (std::size_t p = 0; p < random_formulas::points; ++p) {
        const auto& at = random.point(p);
        const long double scale = std::abs(f.value[p]) * (2 + std::abs(h.value[p])) + 1;
        if (f.error[p] + h.error[p] > 1e-13L * scale) continue;
        ASSERT_LE(std::abs(evaluate({of.g, after[0]}, at) - f.value[p] * h.value[p]), 1e-11L * scale);
        ASSERT_LE(std::abs(evaluate({of.g, after[1]}, at) - evaluate(second, at)), 1e-11L * scale);
      }
    }
  }
  EXPECT_GT(shorter, 300);
}

TEST_F(shortened_sums, quotients_in_lowest_terms) {
  EXPECT_EQ(quotient(-(a * b * x), (a * y) * a), -((b * x) / (a * y)));
  EXPECT_EQ(quotient(a * b, a * b), number(1));
  EXPECT_EQ(quotient(a * a, a), a);
  EXPECT_EQ(quotient(3 * a, 2 * a), fraction(3, 2));
  EXPECT_EQ(quotient(a * b, x * y), (a * b) / (x * y));
  EXPECT_TRUE(quotient(number(0), a).is_zero());
}

} // namespace
