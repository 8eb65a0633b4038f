#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cmath>

/// Functions of two arguments: for expressions and for numbers, with their derivatives. Their plain data are
/// in operation.hpp.
namespace kanexpr::symbolic {

constexpr expression atan2(expression y, expression x) { return apply(operation::atan2, y, x); }

/// The derivatives of a function with respect to its arguments.
template <class Number>
struct binary_slopes {
  Number by_a, by_b;
};

/// `of` is the function for any scalar type; `slopes` are its derivatives at (a, b), where its value is f,
/// for expressions and for numbers. `rate` is optional: the rate of the value if the arguments change at
/// given rates, where this costs less than a product with each slope.
template <operation op>
struct binary_function;

template <>
struct binary_function<operation::atan2> {
  template <class Number>
  static Number of(const Number& y, const Number& x) {
    using std::atan2;
    return atan2(y, x);
  }
  template <class Number>
  static constexpr binary_slopes<Number> slopes(const Number& y, const Number& x, const Number&) {
    const Number first = y * y, second = x * x, square = first + second;
    return {x / square, -(y / square)};
  }
  template <class Number>
  static constexpr Number rate(const Number& y, const Number& x, const Number& y_rate, const Number& x_rate) {
    const Number square = x * x + y * y;
    return (x * y_rate - y * x_rate) / square;
  }
};

/// Calls `use.template operator()<op>()` for a function of two arguments, with `op` as a constant.
template <class Use>
constexpr decltype(auto) with_binary_function(operation op, const Use& use) {
  if (op == operation::atan2) return use.template operator()<operation::atan2>();
  __builtin_unreachable();
}

/// The derivatives of a function of two arguments at (a, b), where its value is f.
template <class Number>
constexpr binary_slopes<Number> binary_slopes_of(operation op, const Number& a, const Number& b,
                                                 const Number& f) {
  return with_binary_function(
      op, [&]<operation function>() { return binary_function<function>::slopes(a, b, f); });
}

/// The rate of a function of two arguments that change at given rates.
template <operation op, class Number>
constexpr Number binary_rate_of(const Number& a, const Number& b, const Number& f, const Number& a_rate,
                                const Number& b_rate) {
  if constexpr (requires { binary_function<op>::rate(a, b, a_rate, b_rate); }) {
    return binary_function<op>::rate(a, b, a_rate, b_rate);
  } else {
    const binary_slopes<Number> by = binary_function<op>::slopes(a, b, f);
    return by.by_a * a_rate + by.by_b * b_rate;
  }
}

} // namespace kanexpr::symbolic
