#pragma once

#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>
#include <vector>

/// Evaluates a graph with numbers of any type, as a check of the library's own evaluation.
namespace graph_evaluation {

namespace base = kanexpr::base;
namespace symbolic = kanexpr::symbolic;
using symbolic::operation;

template <class T>
inline constexpr bool is_complex = false;
template <class T>
inline constexpr bool is_complex<std::complex<T>> = true;

template <class T>
T constant_value(const symbolic::number& n) {
  if constexpr (is_complex<T>)
    return n.value();
  else
    return n.exact() ? static_cast<T>(n.numerator) / static_cast<T>(n.denominator) : static_cast<T>(n.real);
}

template <class T>
T arithmetic(operation op, const T& a, const T& b) {
  switch (op) {
  case operation::negate: return -a;
  case operation::add: return a + b;
  case operation::subtract: return a - b;
  case operation::multiply: return a * b;
  case operation::divide: return a / b;
  case operation::power: return std::pow(a, b);
  case operation::sqrt: return std::sqrt(a);
  case operation::sin: return std::sin(a);
  case operation::cos: return std::cos(a);
  case operation::tan: return std::tan(a);
  case operation::asin: return std::asin(a);
  case operation::acos: return std::acos(a);
  case operation::atan: return std::atan(a);
  case operation::exp: return std::exp(a);
  case operation::log: return std::log(a);
  case operation::sinh: return std::sinh(a);
  case operation::cosh: return std::cosh(a);
  case operation::tanh: return std::tanh(a);
  default: break;
  }
  if constexpr (is_complex<T>) { // the sign is that of the real part, as complex steps require
    if (op == operation::if_positive) return a.real() > 0 ? b : T(0);
    if (op == operation::if_not_positive) return a.real() > 0 ? T(0) : b;
  }
  if constexpr (!is_complex<T>) {
    if (op == operation::atan2) return std::atan2(a, b);
    if (op == operation::abs) return std::abs(a);
    if (op == operation::if_positive) return a > 0 ? b : T(0);
    if (op == operation::if_not_positive) return a > 0 ? T(0) : b;
    if (op == operation::sign) return static_cast<T>((a > 0) - (a < 0));
    if (op == operation::cbrt) return std::cbrt(a);
    if (op == operation::erf) return std::erf(a);
    if (op == operation::wrap_to_pi) return std::remainder(a, static_cast<T>(2 * 3.141592653589793));
  }
  return std::nan("");
}

/// x in A x = b, by elimination with row exchanges; `a` is stored row by row.
template <class T>
std::vector<T> solved(std::vector<std::vector<T>> a, std::vector<T> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const T weight = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= weight * a[k][j];
      b[i] -= weight * b[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) b[k] /= a[k][k];
  return b;
}

/// The solution for a node, from the values of its operands.
template <class T, class At>
std::vector<T> solution(const symbolic::graph& g, const symbolic::node& n, const At& at) {
  const auto order = static_cast<std::size_t>(symbolic::order_of(g, n.a));
  const base::sequence<int> entries = symbolic::entries_of(g, n.a), right = symbolic::elements_of(g, n.b);
  std::vector<std::vector<T>> a(order, std::vector<T>(order));
  std::vector<T> b;
  for (std::size_t i = 0; i < order; ++i) {
    b.push_back(at(right[static_cast<int>(i)]));
    for (std::size_t j = 0; j < order; ++j)
      (n.op == operation::solve ? a[i][j] : a[j][i]) = at(entries[static_cast<int>(i * order + j)]);
  }
  return solved(a, b);
}

/// The product of the pivots of small systems; for larger ones, the smallest pivot relative to the terms of
/// which it is the sum.
template <class T, class At>
T singularity_measure(const symbolic::graph& g, const symbolic::node& n, const At& at) {
  if constexpr (is_complex<T>) {
    return std::nan("");
  } else {
    const int order = symbolic::order_of(g, n.a);
    base::sequence<T> f, squares;
    for (int id : symbolic::entries_of(g, n.a)) f.push(at(id));
    for (int id : symbolic::elements_of(g, n.b)) squares.push(at(id));
    T determinant = 1, least = 0;
    for (int k = 0; k < order; ++k) {
      int pivot = k;
      for (int i = k + 1; i < order; ++i)
        if (std::abs(f[i * order + k]) > std::abs(f[pivot * order + k])) pivot = i;
      for (int j = 0; j < order; ++j) std::swap(f[k * order + j], f[pivot * order + j]);
      const T size = std::abs(f[k * order + k]);
      if (size == 0) return 0;
      determinant *= size;
      for (int j = 0; order > 3 && j < order; ++j)
        std::swap(squares[k * order + j], squares[pivot * order + j]);
      const T beside = order > 3 ? size / std::sqrt(squares[k * order + k]) : size;
      least = k == 0 ? beside : std::min(least, beside);
      for (int i = k + 1; i < order; ++i) {
        const T multiplier = f[i * order + k] / f[k * order + k];
        for (int j = 0; j < order; ++j) f[i * order + j] -= multiplier * f[k * order + j];
        for (int j = k + 1; order > 3 && j < order; ++j)
          squares[i * order + j] += multiplier * multiplier * squares[k * order + j];
      }
    }
    return order <= 3 ? determinant : least;
  }
}

/// `symbols` are the values of `graph::symbols()`, in that order.
template <class T>
T evaluate(symbolic::expression e, const std::vector<T>& symbols) {
  const symbolic::graph& g = e.owner();
  const auto live = symbolic::live_nodes(g, {e.node()});
  std::vector<T> values(static_cast<std::size_t>(e.node()) + 1);
  const auto at = [&values](int id) -> T& { return values[static_cast<std::size_t>(id)]; };
  std::map<int, std::vector<T>> solutions;
  for (int id = 0; id <= e.node(); ++id) {
    const symbolic::node& n = g[id];
    if (live[id] == 0 || n.op == operation::pair || n.op == operation::factorization) continue;
    if (n.op == operation::constant)
      at(id) = constant_value<T>(g.number_at(id));
    else if (n.op == operation::symbol)
      at(id) = symbols[static_cast<std::size_t>(n.a)];
    else if (n.op == operation::solve || n.op == operation::transposed_solve)
      solutions[id] = solution<T>(g, n, at);
    else if (n.op == operation::singularity_measure)
      at(id) = singularity_measure<T>(g, n, at);
    else if (n.op == operation::component)
      at(id) = solutions[n.a][static_cast<std::size_t>(symbolic::integer_at(g, n.b))];
    else
      at(id) = arithmetic(n.op, at(n.a), symbolic::is_binary(n.op) ? at(n.b) : T(0));
  }
  return at(e.node());
}

inline bool are_close(long double a, long double b, long double tolerance) {
  return std::abs(a - b) <= tolerance;
}

} // namespace graph_evaluation
