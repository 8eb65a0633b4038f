// builds: clang++ sanitize
#include "symbolic/linear/linear_systems.hpp"
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;
using real = long double;

/// A = S D T and b = S D y with D = diag(v, v², 1, ...), where v vanishes at q1 = 0: x tends to the solution
/// of T x = y, although A is singular there.
class nearly_singular {
public:
  nearly_singular(int n, unsigned seed, bool is_symbolic) : a(s.g, n, n), t(s.g, n, n), engine_(seed) {
    matrix left(s.g, n, n), scaled(s.g, n, n);
    sequence<expression> scales;
    const expression v = sin(s.q1), parameter = is_symbolic ? s.a : s.fraction(7, 5);
    for (int i = 0; i < n; ++i) {
      scales.push(i == 0 ? v : i == 1 ? v * tan(s.q1) : s.number(1));
      y.push(regular());
      for (int j = 0; j < n; ++j) {
        left(i, j) = regular() + (i == j ? 3 : 0), t(i, j) = regular() + (i == j ? 3 : 0);
        if (i == (j + 1) % n) t(i, j) = t(i, j) * parameter;
      }
    }
    for (int i = 0; i < n; ++i) {
      expression right = s.number(0);
      for (int j = 0; j < n; ++j) {
        scaled(i, j) = left(i, j) * scales[j];
        right += scaled(i, j) * y[j];
      }
      b.push(right);
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) a(i, j) += scaled(i, k) * t(k, j);
  }

  symbols s;
  matrix a, t;
  sequence<expression> b, y;

private:
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  expression regular() {
    return s.number(uniform()) * cos(s.number(uniform()) * s.q1) + s.number(uniform()) * sin(s.q1);
  }

  std::mt19937 engine_;
};

matrix transpose(const matrix& a) {
  matrix t = a;
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < a.rows; ++j) t(j, i) = a(i, j);
  return t;
}

matrix column(graph& g, const sequence<expression>& x) {
  matrix m(g, x.size(), 1);
  m.entries = x;
  return m;
}

TEST(limits_of_solutions, exist_where_the_matrix_alone_is_singular) {
  for (const bool is_symbolic : {false, true})
    for (const int n : {2, 3, 4, 5, 6}) {
      if (is_symbolic && n > 5) continue;
      for (const bool is_transposed : {false, true}) {
        nearly_singular random(n, static_cast<unsigned>(n), is_symbolic);
        graph& g = random.s.g;
        const expression factors = factorization(g, is_transposed ? transpose(random.a) : random.a);
        const auto x = is_transposed ? solve_transposed(factors, random.b) : solve(factors, random.b);
        const point_values found = limits_at(g, column(g, x), {{random.s.q1, random.s.number(0)}});
        ASSERT_TRUE(found.singular.empty()) << n << ' ' << found.singular[0].condition;
        std::vector<real> values(static_cast<std::size_t>(g.symbols().size()), 0);
        values[static_cast<std::size_t>(g[random.s.a.node()].a)] = 1.4L;
        const sequence<expression> expected = solve(factorization(g, random.t), random.y);
        for (int i = 0; i < n; ++i) {
          const real wanted = evaluate(expected[i], values);
          EXPECT_EQ(found.values(i, 0).is_constant(), !is_symbolic);
          EXPECT_PRED3(are_close, evaluate(found.values(i, 0), values), wanted,
                       1e-11L * (1 + std::abs(wanted)))
              << n << ' ' << is_symbolic;
        }
      }
    }
}

class limits_of_systems : public testing::Test, protected symbols {
protected:
  matrix of(std::initializer_list<expression> entries, int order) {
    matrix filled(g, order, order);
    filled.entries = entries;
    return filled;
  }
  point_values at_zero(const sequence<expression>& solution) {
    return limits_at(g, column(g, solution), {{q1, number(0)}});
  }
};

TEST_F(limits_of_systems, are_exact) {
  const expression one = number(1), q = q1;
  const auto two = at_zero(solve(factorization(g, of({sin(q), q, q, 3 * q}, 2)), {q, 2 * tan(q)}));
  EXPECT_EQ(two.values(0, 0), fraction(1, 2));
  EXPECT_EQ(two.values(1, 0), fraction(1, 2));
  const auto three = at_zero(solve(factorization(g, of({q, one, one, one, q, one, q, q, q}, 3)), {q, q, q}));
  EXPECT_EQ(three.values(0, 0), one);
  EXPECT_EQ(three.values(1, 0), one);
  EXPECT_EQ(three.values(2, 0), -one);
}

TEST_F(limits_of_systems, may_not_exist) {
  const expression q = q1, one = number(1);
  const point_values found = at_zero(solve(factorization(g, of({q, sin(q), q, 2 * q}, 2)), {one, x}));
  ASSERT_EQ(found.singular.size(), 2u);
  EXPECT_EQ(found.singular[0].condition,
            "the linear system with [[q1, sin(q1)], [q1, 2*q1]] is singular at q1 = 0");
  const point_values always = at_zero(solve(factorization(g, of({a, b, 2 * a + q - q, 2 * b}, 2)), {one, q}));
  EXPECT_EQ(always.singular[0].condition,
            "the linear system with [[a, b], [2*a, 2*b]] is singular everywhere");
  matrix large(g, 4, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) large(i, j) = sin(number(i * j) * q + cos(x + y * z)) * tan(a * y) + a * x;
  const point_values four = at_zero(solve(factorization(g, large), {one, one, q, x}));
  EXPECT_EQ(four.singular[0].condition, "a linear system of order 4 is singular at q1 = 0");
}

TEST_F(limits_of_systems, expand_solutions_of_regular_ones) {
  for (const int n : {2, 3, 5}) {
    moving_system system(n, static_cast<unsigned>(n) + 10);
    graph& all = system.g;
    const sequence<expression> solution = solve(factorization(all, system.a), system.b);
    const expression middle = variable(all, {symbol_kind::parameter, "middle", 0});
    substitution there(all);
    there.replace(system.q[0], middle);
    matrix slopes(all, n, 1);
    sequence<expression> expected;
    for (int i = 0; i < n; ++i) {
      slopes(i, 0) = (solution[i] - there.in(solution[i])) / (system.q[0] - middle);
      expected.push(there.in(differentiate(solution[i], system.q[0])));
    }
    std::vector<real> values = system.at;
    values.push_back(values[0]);
    const point_values symbolic = limits_at(all, slopes, {{system.q[0], middle}});
    std::vector<replacement> numbers{
        {middle, constant(all, kanexpr::symbolic::real(static_cast<double>(values[0])))}};
    for (int k = 0; k < 3; ++k)
      numbers.push_back({system.q[k], constant(all, kanexpr::symbolic::real(static_cast<double>(
                                                        values[static_cast<std::size_t>(2 * k)])))});
    const point_values numeric = limits_at(all, slopes, numbers);
    ASSERT_TRUE(symbolic.singular.empty()) << symbolic.singular[0].condition;
    ASSERT_TRUE(numeric.singular.empty()) << numeric.singular[0].condition;
    for (int i = 0; i < n; ++i) {
      const real wanted = evaluate(expected[i], values), tolerance = 1e-12L * (1 + std::abs(wanted));
      EXPECT_PRED3(are_close, evaluate(symbolic.values(i, 0), values), wanted, tolerance);
      ASSERT_TRUE(numeric.values(i, 0).is_constant());
      EXPECT_PRED3(are_close, evaluate(numeric.values(i, 0), values), wanted, tolerance);
    }
  }
}

TEST_F(limits_of_systems, are_numbers_where_all_is_numbers) {
  for (int n = 2; n <= 10; ++n) {
    moving_system system(n, static_cast<unsigned>(n));
    std::vector<replacement> point;
    for (int k = 0; k < 3; ++k)
      point.push_back({system.q[k], constant(system.g, kanexpr::symbolic::real(static_cast<double>(
                                                           system.at[static_cast<std::size_t>(2 * k)])))});
    const sequence<expression> solution = solve(factorization(system.g, system.a), system.b);
    const point_values found = limits_at(system.g, column(system.g, solution), point);
    ASSERT_TRUE(found.singular.empty());
    for (int i = 0; i < n; ++i) {
      const real wanted = system.value_of(solution[i]);
      ASSERT_TRUE(found.values(i, 0).is_constant());
      EXPECT_PRED3(are_close, evaluate(found.values(i, 0), system.at), wanted,
                   1e-12L * (1 + std::abs(wanted)));
    }
  }
}

} // namespace
