#pragma once

#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/expression.hpp>

#include <cmath>
#include <complex>
#include <vector>

/// Walks a graph with numbers of any type, to check what the library makes of it.
namespace graph_evaluation {

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
  default: break;
  }
  if constexpr (!is_complex<T>) {
    if (op == operation::atan2) return std::atan2(a, b);
    if (op == operation::abs) return std::abs(a);
    if (op == operation::sign) return static_cast<T>((a > 0) - (a < 0));
  }
  return std::nan("");
}

/// `symbols` are the values of `graph::symbols()`, in that order.
template <class T>
T evaluate(symbolic::expression e, const std::vector<T>& symbols) {
  const symbolic::graph& g = e.owner();
  const symbolic::sequence<char> live = symbolic::live_nodes(g, {e.node()});
  std::vector<T> values(static_cast<std::size_t>(e.node()) + 1);
  const auto at = [&values](int id) -> T& { return values[static_cast<std::size_t>(id)]; };
  for (int id = 0; id <= e.node(); ++id) {
    const symbolic::node& n = g[id];
    if (live[id] == 0) continue;
    if (n.op == operation::constant)
      at(id) = constant_value<T>(g.number_at(id));
    else if (n.op == operation::symbol)
      at(id) = symbols[static_cast<std::size_t>(n.a)];
    else
      at(id) = arithmetic(n.op, at(n.a), symbolic::is_binary(n.op) ? at(n.b) : T(0));
  }
  return at(e.node());
}

inline bool are_close(long double a, long double b, long double tolerance) {
  return std::abs(a - b) <= tolerance;
}

} // namespace graph_evaluation
