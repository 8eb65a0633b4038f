// builds: clang++ sanitize
#include "entry_squares.hpp"
#include "linear_systems.hpp"

#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;

class expand : public testing::Test {
protected:
  graph g;

  expression number(int value) { return constant(g, exactly(value)); }
  /// A matrix with a symbol for each letter of the pattern; equal letters denote equal entries.
  expression factors_of(const char* pattern, int order) {
    matrix filled(g, order, order);
    for (int i = 0; i < order * order; ++i)
      if (pattern[i] != '.') filled.entries[i] = symbol('A', pattern[i]);
    return factorization(g, filled);
  }
  sequence<expression> right_side(char called, int order) {
    sequence<expression> b;
    for (int i = 0; i < order; ++i) b.push(symbol(called, static_cast<char>('1' + i)));
    return b;
  }
  cost of(const sequence<expression>& outputs) const { return cost_of(g, nodes_of(outputs)); }

  expression symbol(char first, char second) {
    const char called[]{first, second, '\0'};
    return variable(g, {symbol_kind::parameter, kanexpr::base::name(called), 0});
  }
};

void append(sequence<expression>& all, const sequence<expression>& more) {
  for (const expression& e : more) all.push(e);
}

TEST(expanded, solutions_have_the_same_values) {
  for (const int n : {2, 3, 4}) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      moving_system s(n, seed);
      const expression factors = factorization(s.g, s.a);
      sequence<expression> outputs = solve(factors, s.b);
      append(outputs, solve_transposed(factors, outputs)); // depends on the first
      differentiation d(s.g);
      d.set_rate(s.q[0], s.rates[0]);
      append(outputs, {d.of(outputs[0]), d.of(outputs[n]), singularity_measure(factors, entry_squares(s.a))});
      const sequence<int> images = expand_solves(s.g, nodes_of(outputs));
      for (int i = 0; i < outputs.size(); ++i) {
        const long double expected = s.value_of(outputs[i]);
        EXPECT_PRED3(are_close, s.value_of({s.g, images[i]}), expected, 1e-13L * (1 + std::abs(expected)));
      }
      EXPECT_EQ(has_linear_systems(s.g, live_list(s.g, images)), n > 3);
    }
  }
}

TEST_F(expand, a_system_of_two) {
  const expression factors = factors_of("abcd", 2);
  const sequence<expression> x = solve(factors, right_side('x', 2));
  EXPECT_EQ(of({x[0]}), (cost{4, 2, 1, 0, 0, 7, 0, 2})); // one numerator, one determinant
  EXPECT_EQ(of(x), (cost{8, 3, 1, 0, 0, 12, 0, 3}));     // one reciprocal
  const expression triangular = factors_of("a.cd", 2);
  EXPECT_EQ(of(solve(triangular, right_side('x', 2))).multiplications, 6);
}

TEST_F(expand, a_system_of_three_by_columns_for_one_right_side) {
  const expression factors = factors_of("abcdefghi", 3);
  sequence<expression> x = solve(factors, right_side('x', 3));
  // three minors of A and three with the right-hand side; the determinant, three numerators, one with a sign,
  // and three products
  EXPECT_EQ(of(x), (cost{6 + 6 + 3 + 9 + 3, 6 + 2 + 6, 1, 0, 0, 43, 0, 6 + 2 + 6}));
  EXPECT_EQ(of({x[1]}).divisions, 1);
  append(x, solve(factors, right_side('y', 3)));
  append(x, solve(factors, right_side('z', 3)));
  // nine minors once, then nine products and three for each right-hand side
  EXPECT_EQ(of(x).multiplications, 18 + 3 + 3 * 12);
  for (const char called : {'t', 'u', 'v'}) append(x, solve(factors, right_side(called, 3)));
  // for four or more, it is cheaper to divide the cofactors
  EXPECT_EQ(of(x).multiplications, 18 + 3 + 9 + 6 * 9);
  EXPECT_EQ(of(x).divisions, 1);
}

TEST_F(expand, a_transposed_system_costs_the_same) {
  const expression factors = factors_of("abcdefghi", 3);
  EXPECT_EQ(of(solve_transposed(factors, right_side('x', 3))), of(solve(factors, right_side('x', 3))));
}

TEST_F(expand, zeros_vanish) {
  // a full matrix costs 27
  EXPECT_LE(of(solve(factors_of("a.c.ef.hi", 3), right_side('x', 3))).multiplications, 22);
  EXPECT_LE(of(solve(factors_of("ab.de.g.i", 3), right_side('x', 3))).multiplications, 20);
  EXPECT_LE(of(solve(factors_of("a.cde..hi", 3), right_side('x', 3))).multiplications, 20);
}

TEST_F(expand, a_matrix_of_numbers_is_inverted) {
  matrix numbers(g, 4, 4);
  for (int i = 0; i < 4; ++i) numbers(i, (i + 1) % 4) = number(2), numbers(i, i) = number(i);
  const sequence<expression> x = solve(factorization(g, numbers), right_side('x', 4));
  const cost found = of(x);
  EXPECT_EQ(found.divisions, 0);
  EXPECT_LE(found.multiplications, 16);
  // 2 x2 = b1
  const sequence<int> images = expand_solves(g, nodes_of(x));
  EXPECT_EQ((expression{g, images[1]}), right_side('x', 4)[0] / 2);
}

TEST_F(expand, larger_systems_stay) {
  const expression factors = factors_of("abcdefghijklmnop", 4);
  sequence<expression> x = solve(factors, right_side('x', 4));
  EXPECT_EQ(of(x), (cost{14 + 6 + 16, 14 + 6 + 12, 4, 0, 0, 72, 0, 14 + 12}));
  append(x, solve_transposed(factors, right_side('y', 4)));
  EXPECT_EQ(of(x), (cost{14 + 6 + 32, 14 + 6 + 24, 4, 0, 0, 72 + 28, 0, 14 + 24}));
}

/// A chain of systems; the entries of each are solutions of the previous one.
TEST_F(expand, is_cheap_where_much_is_shared) {
  sequence<expression> entries;
  for (const char letter : {'a', 'b', 'c', 'd'}) entries.push(symbol('A', letter));
  for (int i = 0; i < 40; ++i) {
    matrix filled(g, 2, 2);
    filled.entries = entries;
    const expression factors = factorization(g, filled);
    entries = solve(factors, {entries[0], entries[1]});
    append(entries, solve(factors, {entries[1], number(1)}));
  }
  EXPECT_LT(of(entries).nodes, 40 * 30);
}

constexpr int compiled() {
  graph g;
  const expression q = variable(g, {symbol_kind::coordinate, "q", 0});
  matrix a(g, 2, 2);
  a(0, 1) = q, a(1, 0) = sin(q), a(1, 1) = constant(g, exactly(3));
  return cost_of(g, nodes_of(solve(factorization(g, a), {q, q * q}))).multiplications;
}
static_assert(compiled() <= 8);

} // namespace
