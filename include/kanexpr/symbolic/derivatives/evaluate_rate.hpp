#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>

namespace kanexpr::symbolic {

/// A number and its derivative in time.
struct rated {
  double value = 0;
  double rate = 0;
};

/// One operation on numbers that change. What `value_of` does not define is left to those who look at the
/// result: it is not a number then.
constexpr rated rated_value_of(operation op, rated a, rated b) {
  const double value = value_of(op, a.value, b.value);
  const auto along = [&](double by_a) { return rated{value, numeric::equal(by_a, 0.0) ? 0 : by_a * a.rate}; };
  switch (op) {
  case operation::negate: return along(-1);
  case operation::add: return {value, a.rate + b.rate};
  case operation::subtract: return {value, a.rate - b.rate};
  case operation::multiply: return {value, a.rate * b.value + a.value * b.rate};
  case operation::divide: return {value, (a.rate - value * b.rate) / b.value};
  case operation::power:
    return {value,
            (numeric::equal(a.rate, 0.0) ? 0 : b.value * elementary::pow(a.value, b.value - 1) * a.rate) +
                (numeric::equal(b.rate, 0.0) ? 0 : value * elementary::log(a.value) * b.rate)};
  case operation::sqrt: return along(value > 0 ? 0.5 / value : elementary::detail::not_a_number);
  case operation::sin: return along(elementary::cos(a.value));
  case operation::cos: return along(-elementary::sin(a.value));
  case operation::tan: return along(1 + value * value);
  case operation::asin: return along(1 / elementary::sqrt((1 - a.value) * (1 + a.value)));
  case operation::acos: return along(-1 / elementary::sqrt((1 - a.value) * (1 + a.value)));
  case operation::atan: return along(1 / (1 + a.value * a.value));
  case operation::atan2: {
    const double square = a.value * a.value + b.value * b.value;
    return {value, (b.value * a.rate - a.value * b.rate) / square};
  }
  case operation::exp: return along(value);
  case operation::log: return along(1 / a.value);
  case operation::abs: return along(a.value < 0 ? -1 : 1);
  default: return {value, 0};
  }
}

/// Evaluates some outputs and their derivatives in time, without making expressions of these.
class rate_evaluation {
public:
  constexpr rate_evaluation(const graph& g, const sequence<int>& outputs) : g_(g), at_(g.size()) {
    const sequence<char> live = live_nodes(g, outputs);
    for (int id = 0; id < g.size(); ++id)
      if (live[id] != 0) live_.push(id);
  }

  /// `of_symbol(id)` gives the value and the rate of a symbol by its node.
  template <class OfSymbol>
  constexpr void at(OfSymbol of_symbol) {
    for (int id : live_) {
      const node& n = g_[id];
      if (n.op == operation::constant)
        at_[id] = {g_.number_at(id).value(), 0};
      else if (n.op == operation::symbol)
        at_[id] = of_symbol(id);
      else
        at_[id] = n.op < operation::pair ? defined(n.op, at_[n.a], is_binary(n.op) ? at_[n.b] : rated{})
                                         : undefined;
    }
  }

  constexpr const rated& operator[](int id) const { return at_[id]; }

private:
  static constexpr rated undefined{elementary::detail::not_a_number, elementary::detail::not_a_number};

  // A constant expression must not divide by zero.
  static constexpr rated defined(operation op, rated a, rated b) {
    if (!is_finite(a) || !is_finite(b)) return undefined;
    if ((op == operation::divide && numeric::equal(b.value, 0.0)) || (op == operation::log && !(a.value > 0)))
      return undefined;
    if ((op == operation::asin || op == operation::acos) && !(a.value > -1 && a.value < 1)) return undefined;
    if (op == operation::atan2 && numeric::equal(a.value, 0.0) && numeric::equal(b.value, 0.0))
      return undefined;
    return rated_value_of(op, a, b);
  }
  static constexpr bool is_finite(rated x) {
    return elementary::detail::is_finite(x.value) && elementary::detail::is_finite(x.rate);
  }

  const graph& g_;
  sequence<int> live_{}; ///< in the order of their numbers
  sequence<rated> at_;
};

} // namespace kanexpr::symbolic
