// builds: sanitize
#include "entry_squares.hpp"
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;

TEST(values, agree_with_long_arithmetic) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 40; ++i) {
      const random_formulas::formula f = random.make(1 + i % 4);
      const sequence<double> values = values_at(s.g, {f.e.node()}, [&](int id) {
        return static_cast<double>(random.point(0)[static_cast<std::size_t>(s.g[id].a)]);
      });
      const long double tolerance = 1e-12L * std::abs(f.value[0]) + 1000 * f.error[0];
      ASSERT_PRED3(are_close, values[0], f.value[0], tolerance) << seed << ' ' << i;
    }
  }
}

/// 1/a, log(a) and the solution of [a 1; 1 a] x = [1 0] with its singularity measure, at two values of a.
constexpr bool defined_or_not() {
  graph g;
  const expression a = variable(g, {symbol_kind::parameter, "a", 0}), one{g, graph::one};
  matrix m(g, 2, 2);
  m(0, 0) = m(1, 1) = a;
  m(0, 1) = m(1, 0) = one;
  const expression factors = factorization(g, m);
  const sequence<expression> x = solve(factors, {one, expression{g, graph::zero}});
  const sequence<int> outputs{(one / (a - 1)).node(), (x[0] + a).node(), x[1].node(),
                              singularity_measure(factors, entry_squares(m)).node(),
                              solve_transposed(factors, {a, a})[1].node()};
  evaluation at(g, outputs);
  at.at([](int) { return 2.0; });
  const auto near = [&](int i, double expected) {
    return kanexpr::numeric::elementary::abs(at[outputs[i]] - expected) < 1e-15;
  };
  const bool regular =
      near(0, 1) && near(1, 2 / 3.0 + 2) && near(2, -1 / 3.0) && near(3, 3) && near(4, 2 / 3.0);
  at.at([](int) { return 1.0; });
  const auto undefined = [&](int i) { return at[outputs[i]] != at[outputs[i]]; };
  return regular && undefined(0) && undefined(1) && undefined(2) && at[outputs[3]] == 0 && undefined(4);
}
static_assert(defined_or_not());

TEST(values, are_not_a_number_where_they_are_not_defined) { EXPECT_TRUE(defined_or_not()); }

/// A cyclic matrix with a on and above the diagonal ring needs pivots; x is all ones.
constexpr double worst_error(int n) {
  graph g;
  const expression a = variable(g, {symbol_kind::parameter, "a", 0});
  matrix m(g, n, n);
  sequence<expression> b(n, expression{g, graph::zero}), c = b;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i != j) m(i, j) = a / (1 + (i * 7 + j * 3) % 5) + ((i + 1) % n == j ? 3 : 0);
      b[i] += m(i, j);
      c[j] += m(i, j);
    }
  const expression factors = factorization(g, m);
  sequence<int> outputs = nodes_of(solve(factors, b));
  for (int id : nodes_of(solve_transposed(factors, c))) outputs.push(id);
  double worst = 0;
  for (double x : values_at(g, outputs, [](int) { return 0.7; })) {
    const double error = kanexpr::numeric::elementary::abs(x - 1);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}
static_assert(worst_error(4) < 1e-14);

TEST(values, of_solutions_of_any_order) {
  for (int n = 2; n <= 9; ++n) EXPECT_LT(worst_error(n), 1e-13) << n;
}

} // namespace
