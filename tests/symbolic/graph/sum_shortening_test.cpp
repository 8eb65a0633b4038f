// builds: sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/graph/factoring.hpp>
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

class factored_sums : public testing::Test, protected symbols {
protected:
  /// The multiplications and additions of all expressions together after factoring, after a check of their
  /// values.
  int operations_of(std::initializer_list<expression> all, std::initializer_list<expression> others = {}) {
    sequence<int> before, kept;
    for (const expression& e : all) before.push(e.node());
    for (const expression& e : others) kept.push(e.node());
    const sequence<int> after = factored(g, before, kept);
    std::vector<long double> at;
    for (int i = 0; i < g.symbols().size(); ++i) at.push_back(0.75L + i * (i % 2 == 0 ? 0.25L : -0.5L));
    for (int i = 0; i < before.size(); ++i)
      EXPECT_NEAR(static_cast<double>(evaluate({g, after[i]}, at) - evaluate({g, before[i]}, at)), 0, 1e-15);
    sequence<int> together = after;
    together.append(kept);
    const cost count = cost_of(g, together);
    return count.multiplications + count.additions;
  }
};

TEST_F(factored_sums, take_out_what_terms_share) {
  EXPECT_EQ(operations_of({a * x + b * x}), 2);                          // (a + b) x
  EXPECT_EQ(operations_of({a * x - y + b * x - m * c * x}), 5);          // (a + b − m c) x − y
  EXPECT_EQ(operations_of({a * x * x + b * x + c}), 4);                  // Horner's scheme
  EXPECT_EQ(operations_of({a * x + b * x, y * a + y * b}), 3);           // a + b once
  EXPECT_EQ(operations_of({a * x + b * x, b * y - z - (m - a * y)}), 5); // also within a longer sum
  EXPECT_EQ(operations_of({a + b + x, a + y + b}), 3);
  EXPECT_EQ(operations_of({a - b + x, y - a + b}), 3);
  EXPECT_EQ(operations_of({a * b * x + y, b * c * a - z}), 5);
}

TEST_F(factored_sums, remain_if_nothing_is_shared) {
  const expression product = a * x, all = product + b * y - c * sin(z);
  EXPECT_EQ(factored(g, {all.node()}, {})[0], all.node());
  EXPECT_EQ(factored(g, {(a + b * x).node()}, {})[0], (a + b * x).node());
}

// A product that is needed in any case is not computed a second time within a factor.
TEST_F(factored_sums, keep_what_else_is_needed) {
  const expression first = a * x, second = b * x;
  EXPECT_EQ(operations_of({first + second}, {first, second}), 3);
  EXPECT_EQ(operations_of({first + second + c * x}, {first}), 4);
}

TEST_F(factored_sums, keep_values_and_never_take_more_operations) {
  int saved = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    symbols of;
    random_formulas random(of, seed);
    for (int i = 0; i < 10; ++i) {
      sequence<int> before, kept;
      std::vector<random_formulas::formula> factors;
      for (int k = 0; k < 6; ++k) factors.push_back(random.make(1 + k % 3));
      for (int k = 0; k < 4; ++k) { // sums of products of a few factors
        expression sum = of.number(0);
        for (int t = 0; t < 6; ++t) {
          const auto any = [&] { return factors[static_cast<std::size_t>(random.pick(6))].e; };
          expression product = any();
          for (int f = random.pick(3); f > 0; --f) product = product * any();
          sum = random.pick(3) == 0 ? sum - product : sum + product;
        }
        (k < 3 ? before : kept).push(sum.node());
      }
      const auto operations = [&](const sequence<int>& nodes) {
        sequence<int> all = nodes;
        all.append(kept);
        const cost count = cost_of(of.g, all);
        return count.multiplications + count.additions;
      };
      const int most = operations(before);
      const sequence<int> after = factored(of.g, before, kept);
      ASSERT_LE(operations(after), most) << seed << ' ' << i;
      saved += most - operations(after);
      for (std::size_t p = 0; p < random_formulas::points; ++p)
        for (int k = 0; k < before.size(); ++k) {
          long double scale = 1;
          for (const auto& f : factors) scale *= 1 + std::abs(f.value[p]);
          const long double expected = evaluate({of.g, before[k]}, random.point(p)),
                            got = evaluate({of.g, after[k]}, random.point(p));
          ASSERT_LE(std::abs(got - expected), 1e-13L * (scale + std::abs(expected))) << seed << ' ' << i;
        }
    }
  }
  EXPECT_GT(saved, 1000);
}

// What a constant expression contains is what the running program computes.
TEST_F(factored_sums, are_the_same_in_constant_expressions) {
  constexpr auto of_a_small_graph = [] {
    graph own;
    const auto symbol = [&](const char* name) {
      return variable(own, {symbol_kind::parameter, kanexpr::base::name(name), 0});
    };
    const expression s = symbol("s"), t = symbol("t"), u = symbol("u"), v = symbol("v");
    const expression first = s * u + t * u, second = v - t * v, third = second - s * v;
    const sequence<int> after = factored(own, {first.node(), third.node()}, {});
    const cost count = cost_of(own, after);
    return count.multiplications + count.additions;
  };
  static_assert(of_a_small_graph() == 4); // s + t, times u, times v, v − …
  EXPECT_EQ(of_a_small_graph(), 4);
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
