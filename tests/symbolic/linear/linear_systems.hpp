#pragma once

#include "evaluate_graph.hpp"

#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <random>

/// A linear system whose entries and right-hand sides are functions of a few symbols.
class moving_system {
public:
  using expression = kanexpr::symbolic::expression;
  using real = long double;
  using complex = std::complex<real>;

  moving_system(int n, unsigned seed) : a(g, n, n), engine_(seed) {
    using namespace kanexpr::symbolic;
    for (int i = 0; i < 3; ++i) {
      kanexpr::base::name called("q");
      called.append(i + 1);
      q.push(variable(g, {symbol_kind::coordinate, called, i}));
      rates.push(variable(g, {symbol_kind::coordinate_rate, called, i}));
      for (int twice = 0; twice < 2; ++twice) at.push_back(uniform());
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (i != j && uniform() > -0.6) a(i, j) = entry(); // zeros on the diagonal
    for (int i = 0; i < n; ++i) a(i, (i + 1) % n) = a(i, (i + 1) % n) + 2;
    for (int i = 0; i < n; ++i) b.push(i == 1 ? constant(g, exactly(0)) : entry());
  }

  /// The derivative along q̇ by an imaginary step, at the values of the symbols.
  real along(const expression& e, const std::vector<real>& direction) const {
    constexpr real step = 1e-25L;
    std::vector<complex> values;
    for (std::size_t i = 0; i < at.size(); ++i) values.emplace_back(at[i], step * direction[i]);
    return graph_evaluation::evaluate(e, values).imag() / step;
  }
  real value_of(const expression& e) const { return graph_evaluation::evaluate(e, at); }

  kanexpr::symbolic::graph g;
  kanexpr::symbolic::matrix a;
  kanexpr::base::sequence<expression> b, q, rates;
  std::vector<real> at; ///< a coordinate, its rate, and so on

private:
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  expression number() { return constant(g, kanexpr::symbolic::real(uniform())); }
  expression entry() { return sin(number() * q[0] + number() * q[1]) + number() * q[2] * q[0]; }

  std::mt19937 engine_;
};
