#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::symbolic::limits {

/// A value with a bound on its accumulated rounding error; NaN if undefined.
///
/// Running error analysis: Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.3.
struct bounded {
  double value = 0;
  double error = 0;

  static constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
  static bounded undefined() { return {std::numeric_limits<double>::quiet_NaN(), 0}; }
  /// Adds the rounding error of the result itself.
  static bounded rounded(double value, double error) {
    if (!numeric::is_finite(value) || !numeric::is_finite(error)) return undefined();
    return {value, error + unit_roundoff * std::abs(value)};
  }
  static bounded of(const number& n) {
    const bool is_sure = n.exact() && (n.denominator & (n.denominator - 1)) == 0;
    return is_sure ? bounded{n.value(), 0} : rounded(n.value(), 0);
  }

  bool defined() const { return base::is_number(value); }
  /// Whether the value counts as zero: it is zero or has no significant digit. `0.1 + 0.2 - 0.3` and the
  /// cosine of the double nearest to π/2 vanish; 1e-30 does not. Four times the bound allows for errors made
  /// earlier.
  bool vanishes() const { return std::abs(value) <= 4 * error; }
};

/// Whether an operation with defined operands has no value, or no reliable one.
inline bool is_singular(operation op, const bounded& a, const bounded& b) {
  if (op == operation::divide) return b.vanishes();
  if (op == operation::log) return a.vanishes();
  if (op == operation::sqrt) return a.value < 0 && a.vanishes();
  if (op == operation::asin || op == operation::acos)
    return std::abs(a.value) > 1 && std::abs(a.value) - 1 <= 4 * a.error;
  if (op == operation::tan)
    return a.error > 0 &&
           std::abs(numeric::elementary::cos(a.value)) <= 4 * (a.error + bounded::unit_roundoff);
  if (op == operation::wrap_to_pi) // may be on either side of a jump
    return a.error > 0 &&
           numeric::elementary::detail::half_turn - std::abs(numeric::elementary::wrap_to_pi(a.value)) <=
               4 * a.error;
  if (is_binary_function(op))
    return !binary_properties_of(op).is_smooth_at(a.vanishes() ? 0 : a.value, b.vanishes() ? 0 : b.value);
  if (is_selection(op)) return a.vanishes() && !base::equal(a.error, 0.0); // the sign is uncertain
  return op == operation::power && a.vanishes() && (a.value < 0 || !(b.value > 4 * b.error));
}

namespace detail {

/// The error of a square root near its branch point.
inline double branch_point_error(double error, double slope) {
  return base::equal(error, 0.0) ? 0 : error / (std::max)(slope, std::sqrt(error));
}

/// The error of a function of one argument due to the error of its argument.
inline double propagated_error(operation op, const bounded& a, double value) {
  if (base::equal(a.error, 0.0)) return 0;
  const double x = a.value;
  if (op == operation::abs) return a.error;
  if (op == operation::sign) return !base::equal(x, 0.0) && a.vanishes() ? 1 : 0;
  if (op == operation::sqrt) return branch_point_error(a.error, value);
  if (op == operation::asin || op == operation::acos)
    return 2 * branch_point_error(a.error, std::sqrt((std::max)(0.0, 1 - x * x)));
  const function_properties& f = properties_of(op);
  if (std::abs(x - f.steep_at) <= a.error)
    return (std::max)(f.value(x + a.error) - value, value - f.value(x - a.error));
  double steepest = 0;
  for (const double at : {x - a.error, x, x + a.error}) {
    if (!f.is_smooth_at(at)) return std::numeric_limits<double>::infinity();
    steepest = (std::max)(steepest, std::abs(slope_of(op, at, f.value(at))));
  }
  return steepest * a.error;
}

/// The error of an operation due to the errors of its operands.
inline double propagated_error(operation op, const bounded& a, const bounded& b, double value) {
  const double x = std::abs(a.value), y = std::abs(b.value);
  switch (form_of(op)) {
  case form::negate: return a.error;
  case form::add:
  case form::subtract: return a.error + b.error;
  case form::multiply: return x * b.error + y * a.error + a.error * b.error;
  case form::divide: return (a.error + std::abs(value) * b.error) / (y - b.error);
  case form::function: return propagated_error(op, a, value);
  case form::selection: return selected(op, a.value, b.error);
  case form::binary_function: {
    const binary_slopes<double> by = binary_slopes_of(op, a.value, b.value, value);
    return std::abs(by.by_a) * a.error + std::abs(by.by_b) * b.error;
  }
  case form::power:
    if (base::equal(x, 0.0)) return base::equal(a.error, 0.0) ? 0 : std::pow(a.error, b.value);
    return std::abs(value) * (y * a.error / x + std::abs(std::log(x)) * b.error);
  case form::leaf:
  case form::list_operation: break; // not operations on two numbers
  }
  return std::numeric_limits<double>::infinity();
}

} // namespace detail

inline bounded apply(operation op, const bounded& a, const bounded& b) {
  const auto is_exact_zero = [](const bounded& x) {
    return base::equal(x.value, 0.0) && base::equal(x.error, 0.0);
  };
  if (op == operation::multiply && (is_exact_zero(a) || is_exact_zero(b))) return {}; // as in the graph
  if (!a.defined() || is_singular(op, a, b)) return bounded::undefined();
  if (is_selection(op) && is_exact_zero({selected(op, a.value, 1), 0})) return {};
  if (!b.defined()) return bounded::undefined();
  const double value = value_of(op, a.value, b.value);
  return bounded::rounded(value, detail::propagated_error(op, a, b, value));
}
inline bounded operator-(const bounded& a, const bounded& b) { return apply(operation::subtract, a, b); }
inline bounded operator*(const bounded& a, const bounded& b) { return apply(operation::multiply, a, b); }
inline bounded operator/(const bounded& a, const bounded& b) { return apply(operation::divide, a, b); }

} // namespace kanexpr::symbolic::limits
