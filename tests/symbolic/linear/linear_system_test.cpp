// builds: clang++ sanitize
#include "linear_systems.hpp"
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using real = long double;

sequence<expression> solved(bool transposed, expression factors, const sequence<expression>& b) {
  sequence<expression> x;
  if (transposed)
    x = solve_transposed(factors, b);
  else
    x = solve(factors, b);
  return x;
}

int count(const graph& g, operation op, const sequence<int>& outputs) {
  const auto live = live_nodes(g, outputs);
  int found = 0;
  for (int id = 0; id < g.size(); ++id)
    if (live[id] != 0 && g[id].op == op) ++found;
  return found;
}

TEST(solutions, satisfy_the_equations) {
  for (int n = 2; n <= 8; ++n) {
    moving_system s(n, static_cast<unsigned>(n));
    const expression factors = factorization(s.g, s.a);
    const sequence<expression> x = solve(factors, s.b), y = solve_transposed(factors, s.b);
    for (int i = 0; i < n; ++i) {
      real left = 0, left_transposed = 0;
      for (int j = 0; j < n; ++j) {
        left += s.value_of(s.a(i, j)) * s.value_of(x[j]);
        left_transposed += s.value_of(s.a(j, i)) * s.value_of(y[j]);
      }
      EXPECT_PRED3(are_close, left, s.value_of(s.b[i]), 1e-15L);
      EXPECT_PRED3(are_close, left_transposed, s.value_of(s.b[i]), 1e-15L);
    }
  }
}

TEST(solutions, have_derivatives_by_the_same_factors) {
  for (const bool transposed : {false, true})
    for (int n = 2; n <= 8; ++n) {
      moving_system s(n, 20 + static_cast<unsigned>(n));
      const expression factors = factorization(s.g, s.a);
      const sequence<expression> x = solved(transposed, factors, s.b);
      sequence<int> outputs;
      for (int k = 0; k < 3; ++k) {
        std::vector<real> direction(s.at.size(), 0);
        direction[static_cast<std::size_t>(2 * k)] = 1;
        differentiation d(s.g);
        d.set_rate(s.q[k], expression{s.g, graph::one});
        for (const expression e : x) {
          const expression slope = d.of(e);
          outputs.push(slope.node());
          const real expected = s.along(e, direction);
          EXPECT_PRED3(are_close, s.value_of(slope), expected, 1e-14L * (1 + std::abs(expected)));
        }
      }
      EXPECT_EQ(count(s.g, operation::factorization, outputs), 1);
    }
}

TEST(solutions, have_gradients_that_agree_with_derivatives) {
  for (const bool transposed : {false, true})
    for (int n = 2; n <= 7; ++n) {
      moving_system s(n, 40 + static_cast<unsigned>(n));
      const expression factors = factorization(s.g, s.a);
      const sequence<expression> x = solved(transposed, factors, s.b);
      // two components of one solution with different weights, and one on which another solution depends
      const sequence<expression> next = solve(factors, x);
      const expression e = x[0] * s.q[1] + x[n - 1] * x[n - 1] + sin(next[0]);
      accumulation reverse(s.g, {e});
      reverse.seed(e, expression{s.g, graph::one});
      reverse.run();
      for (int k = 0; k < 3; ++k) {
        const expression forward = differentiate(e, s.q[k]);
        const real expected = s.value_of(forward);
        EXPECT_PRED3(are_close, s.value_of(reverse.by(s.q[k])), expected, 1e-14L * (1 + std::abs(expected)));
      }
      sequence<int> gradient;
      for (int k = 0; k < 3; ++k) gradient.push(reverse.by(s.q[k]).node());
      EXPECT_EQ(count(s.g, operation::factorization, gradient), 1);
      EXPECT_LE(count(s.g, operation::solve, gradient) + count(s.g, operation::transposed_solve, gradient),
                4);
    }
}

TEST(solutions, have_second_time_derivatives) {
  for (int n = 2; n <= 6; ++n) {
    moving_system s(n, 60 + static_cast<unsigned>(n));
    const sequence<expression> x = solve(factorization(s.g, s.a), s.b);
    differentiation along_time(s.g);
    for (int k = 0; k < 3; ++k) along_time.set_rate(s.q[k], s.rates[k]);
    std::vector<real> direction(s.at.size(), 0);
    for (std::size_t i = 0; i < s.at.size(); i += 2) direction[i] = s.at[i + 1];
    for (const expression e : x) {
      const expression first = along_time.of(e), second = along_time.of(first);
      EXPECT_PRED3(are_close, s.value_of(first), s.along(e, direction), 1e-13L);
      const real expected = s.along(first, direction);
      EXPECT_PRED3(are_close, s.value_of(second), expected, 1e-12L * (1 + std::abs(expected)));
    }
  }
}

class solution_of_symbols : public testing::Test, protected symbols {
protected:
  matrix of(std::initializer_list<expression> entries, int order) {
    matrix filled(g, order, order);
    filled.entries = entries;
    return filled;
  }
};

TEST_F(solution_of_symbols, is_simple_where_it_can_be) {
  const expression zero = number(0);
  EXPECT_EQ(solve(factorization(g, of({a}, 1)), {b})[0], b / a);
  const expression factors = factorization(g, of({a, b, c, m}, 2));
  EXPECT_EQ(solve(factors, {zero, zero})[1], zero);
  EXPECT_EQ(solve_transposed(factors, {zero, zero})[0], zero);
  // exact numbers give exact numbers
  const expression numbers = factorization(g, of({number(0), number(2), number(3), number(1)}, 2));
  EXPECT_EQ(solve(numbers, {number(1), number(1)})[0], fraction(1, 6));
  EXPECT_EQ(solve_transposed(numbers, {number(1), number(1)})[0], fraction(1, 6) + fraction(1, 6));
  EXPECT_EQ(differentiate(solve(factors, {x, y})[0], z), zero);
}

TEST_F(solution_of_symbols, takes_substitutions) {
  const expression factors = factorization(g, of({a, b, c, m}, 2));
  const sequence<expression> solution = solve(factors, {x, y});
  substitution s(g);
  s.replace(a, number(0));
  s.replace(y, z);
  const expression replaced = factorization(g, of({number(0), b, c, m}, 2));
  EXPECT_EQ(s.in(solution[1]), solve(replaced, {x, z})[1]);
  EXPECT_EQ(s.in(singularity_measure(factors, {r, m})), singularity_measure(replaced, {r, m}));
  substitution at_rest(g);
  at_rest.replace(x, number(0));
  at_rest.replace(y, number(0));
  EXPECT_EQ(at_rest.in(solution[0] + a), a);
}

TEST_F(solution_of_symbols, is_printed) {
  const expression factors = factorization(g, of({a, b, c, m * r}, 2));
  const expression first = solve(factors, {x, 2 * y})[0], second = solve_transposed(factors, {x, y})[1];
  EXPECT_EQ(print(first), "solve([[a, b], [c, m*r]], [x, 2*y])[1]");
  EXPECT_EQ(print(second), "solve([[a, c], [b, m*r]], [x, y])[2]");
  EXPECT_EQ(print(a * first * first - 2 * first), "a*solve([[a, b], [c, m*r]], [x, 2*y])[1]^2 - "
                                                  "2*solve([[a, b], [c, m*r]], [x, 2*y])[1]");
  EXPECT_EQ(print(singularity_measure(factors, {x, y})), "singularity_measure([[a, b], [c, m*r]], [x, y])");
  EXPECT_EQ(latex(first * first), "\\left(\\begin{bmatrix} a & b \\\\ c & m r \\end{bmatrix}^{-1} "
                                  "\\begin{bmatrix} x \\\\ 2 y \\end{bmatrix}\\right)_{1}^{2}");
  EXPECT_EQ(latex(singularity_measure(factors, {x, y})),
            "\\operatorname{singularity\\ measure}\\left(\\begin{bmatrix} a & b \\\\ c & m r "
            "\\end{bmatrix}\\right)");
}

constexpr bool compiled() {
  graph g;
  const expression q = variable(g, {symbol_kind::coordinate, "q", 0});
  matrix a(g, 2, 2);
  a(0, 1) = q, a(1, 0) = q * q, a(1, 1) = sin(q);
  const sequence<expression> x = solve(factorization(g, a), {q, cos(q)});
  accumulation reverse(g, x);
  reverse.seed(x[1], constant(g, exactly(1)));
  reverse.run();
  return differentiate(x[0], q) != x[0] && !reverse.by(q).is_zero();
}
static_assert(compiled());

} // namespace
