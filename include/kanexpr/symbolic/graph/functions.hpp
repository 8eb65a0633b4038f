#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/selection.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <type_traits>

/// Functions of one and of two arguments: for expressions and for numbers, with their derivatives. Their
/// other properties are rows of function_table.hpp.
namespace kanexpr::symbolic {

constexpr expression sqrt(expression a) { return apply(operation::sqrt, a); }
constexpr expression sin(expression a) { return apply(operation::sin, a); }
constexpr expression cos(expression a) { return apply(operation::cos, a); }
constexpr expression tan(expression a) { return apply(operation::tan, a); }
constexpr expression asin(expression a) { return apply(operation::asin, a); }
constexpr expression acos(expression a) { return apply(operation::acos, a); }
constexpr expression atan(expression a) { return apply(operation::atan, a); }
constexpr expression exp(expression a) { return apply(operation::exp, a); }
constexpr expression log(expression a) { return apply(operation::log, a); }
constexpr expression sinh(expression a) { return apply(operation::sinh, a); }
constexpr expression cosh(expression a) { return apply(operation::cosh, a); }
constexpr expression tanh(expression a) { return apply(operation::tanh, a); }
constexpr expression abs(expression a) { return apply(operation::abs, a); }
constexpr expression sign(expression a) { return apply(operation::sign, a); }
constexpr expression cbrt(expression a) { return apply(operation::cbrt, a); }
constexpr expression erf(expression a) { return apply(operation::erf, a); }
constexpr expression wrap_to_pi(expression a) { return apply(operation::wrap_to_pi, a); }

/// The sign of a number; NaN if the number is NaN.
template <class Number>
Number sign_of(const Number& x) {
  const auto sign = static_cast<Number>((Number(0) < x) - (x < Number(0)));
  if constexpr (numeric::selected_by_masks<Number>)
    return numeric::where_number(x, sign);
  else if constexpr (std::is_arithmetic_v<Number>)
    return base::is_number(x) ? sign : x;
  else
    return sign;
}

/// The equivalent angle in [-π, π). The remainder is exact, so the value does not depend on the compiler or
/// the processor.
template <class Number>
Number wrapped_to_pi(const Number& x) {
  if constexpr (std::is_floating_point_v<Number>) {
    constexpr Number pi = std::numbers::pi_v<Number>;
    const Number r = std::remainder(x, 2 * pi);
    return r - static_cast<Number>(r >= pi) * (2 * pi);
  } else {
    return wrap_to_pi(x);
  }
}

/// A function of one argument for any scalar type.
template <operation op, class Number>
Number function_value(const Number& x) {
  using std::sinh, std::cosh, std::tanh, std::abs, std::cbrt, std::erf;
  using std::sqrt, std::sin, std::cos, std::tan, std::asin, std::acos, std::atan, std::exp, std::log;
  if constexpr (op == operation::sqrt) return sqrt(x);
  if constexpr (op == operation::sin) return sin(x);
  if constexpr (op == operation::cos) return cos(x);
  if constexpr (op == operation::tan) return tan(x);
  if constexpr (op == operation::asin) return asin(x);
  if constexpr (op == operation::acos) return acos(x);
  if constexpr (op == operation::atan) return atan(x);
  if constexpr (op == operation::exp) return exp(x);
  if constexpr (op == operation::log) return log(x);
  if constexpr (op == operation::sinh) return sinh(x);
  if constexpr (op == operation::cosh) return cosh(x);
  if constexpr (op == operation::tanh) return tanh(x);
  if constexpr (op == operation::abs) return abs(x);
  if constexpr (op == operation::sign) return sign_of(x);
  if constexpr (op == operation::cbrt) return cbrt(x);
  if constexpr (op == operation::erf) return erf(x);
  if constexpr (op == operation::wrap_to_pi) return wrapped_to_pi(x);
}

/// The derivative of a function of one argument at x, where its value is f, for expressions and for
/// compile-time numbers.
template <operation op, class Number>
constexpr Number function_slope(const Number& x, const Number& f) {
  using numeric::elementary::exp, numeric::elementary::sinh, numeric::elementary::cosh;
  using numeric::elementary::sign;
  using numeric::elementary::sqrt, numeric::elementary::sin, numeric::elementary::cos;
  if constexpr (op == operation::sqrt) return 1 / (2 * f);
  if constexpr (op == operation::sin) return cos(x);
  if constexpr (op == operation::cos) return -sin(x);
  if constexpr (op == operation::tan) return f * f + 1;
  if constexpr (op == operation::asin) return 1 / sqrt(1 - x * x);
  if constexpr (op == operation::acos) return -(1 / sqrt(1 - x * x));
  if constexpr (op == operation::atan) return 1 / (x * x + 1);
  if constexpr (op == operation::exp) return f;
  if constexpr (op == operation::log) return 1 / x;
  if constexpr (op == operation::sinh) return cosh(x);
  if constexpr (op == operation::cosh) return sinh(x);
  if constexpr (op == operation::tanh) return 1 - f * f;
  if constexpr (op == operation::abs) return sign(x);
  if constexpr (op == operation::sign) return x - x;
  if constexpr (op == operation::cbrt) return 1 / (3 * (f * f));
  if constexpr (op == operation::erf) return 2 * std::numbers::inv_sqrtpi * exp(-(x * x));
  if constexpr (op == operation::wrap_to_pi) return 1 + (x - x);
}

/// Calls `use.template operator()<op>()` for an operation in the rows of a table, with `op` as a constant.
template <const auto& table, std::size_t place = 0, class Use>
constexpr decltype(auto) with_row_of(operation op, const Use& use) {
  if constexpr (place + 1 < std::size(table))
    if (op != table[place].op) return with_row_of<table, place + 1>(op, use);
  return use.template operator()<table[place].op>();
}

/// Calls `use.template operator()<op>()` for a function of one argument.
template <class Use>
constexpr decltype(auto) with_function(operation op, const Use& use) {
  return with_row_of<functions>(op, use);
}

/// The derivative of a function of one argument at x, where its value is f.
template <class Number>
constexpr Number slope_of(operation op, const Number& x, const Number& f) {
  return with_function(op, [&]<operation function>() { return function_slope<function>(x, f); });
}

constexpr expression atan2(expression y, expression x) { return apply(operation::atan2, y, x); }

/// The derivatives of a function with respect to its arguments.
template <class Number>
struct binary_slopes {
  Number by_a, by_b;
};

/// `of` is the function for any scalar type; `slopes` are its derivatives at (a, b), where its value is f,
/// for expressions and for numbers. `rate` is optional: it gives the rate of the value for given rates of the
/// arguments, if this costs less than multiplying them by the slopes.
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

/// Calls `use.template operator()<op>()` for a function of two arguments.
template <class Use>
constexpr decltype(auto) with_binary_function(operation op, const Use& use) {
  return with_row_of<binary_functions>(op, use);
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
