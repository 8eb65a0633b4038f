#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::symbolic::taylor {

/// A value, and a bound on what rounding has done to it on the way. Not-a-number where it is not defined.
///
/// Running error analysis: Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.3.
struct bounded {
  double value = 0;
  double error = 0;

  static constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
  static bounded undefined() { return {std::numeric_limits<double>::quiet_NaN(), 0}; }
  /// A result that was rounded once more.
  static bounded rounded(double value, double error) {
    if (!std::isfinite(value) || !std::isfinite(error)) return undefined();
    return {value, error + unit_roundoff * std::abs(value)};
  }
  static bounded of(const number& n) {
    const bool is_sure = n.exact() && (n.denominator & (n.denominator - 1)) == 0;
    return is_sure ? bounded{n.value(), 0} : rounded(n.value(), 0);
  }

  bool defined() const { return numeric::is_number(value); }
  /// Whether it counts as zero: it is, or not a digit of it is sure. `0.1 + 0.2 - 0.3` vanishes, and the
  /// cosine of the double next to π/2; 1e-30 does not. Four times the bound allows for what came before.
  bool vanishes() const { return std::abs(value) <= 4 * error; }
};

/// Whether an operation has no value at operands that are defined, or none that is sure.
inline bool is_singular(operation op, const bounded& a, const bounded& b) {
  switch (op) {
  case operation::divide: return b.vanishes();
  case operation::log: return a.vanishes();
  case operation::sqrt: return a.value < 0 && a.vanishes();
  case operation::asin:
  case operation::acos: return std::abs(a.value) > 1 && std::abs(a.value) - 1 <= 4 * a.error;
  case operation::tan:
    return a.error > 0 && std::abs(elementary::cos(a.value)) <= 4 * (a.error + bounded::unit_roundoff);
  case operation::atan2: return a.vanishes() && b.vanishes();
  case operation::power: return a.vanishes() && (a.value < 0 || !(b.value > 4 * b.error));
  default: return false;
  }
}

namespace detail {

/// The part of an error that remains near a square root's branch point.
inline double past_branch(double error, double slope) {
  return numeric::equal(error, 0.0) ? 0 : error / (std::max)(slope, std::sqrt(error));
}

/// How far errors of the operands move the value of an operation.
inline double carried_error(operation op, const bounded& a, const bounded& b, double value) {
  const double x = std::abs(a.value), y = std::abs(b.value);
  switch (op) {
  case operation::add:
  case operation::subtract: return a.error + b.error;
  case operation::multiply: return x * b.error + y * a.error + a.error * b.error;
  case operation::divide: return (a.error + std::abs(value) * b.error) / (y - b.error);
  case operation::sqrt: return past_branch(a.error, std::abs(value));
  case operation::asin:
  case operation::acos: return 2 * past_branch(a.error, std::sqrt((std::max)(0.0, 1 - x * x)));
  case operation::atan: return a.error / (1 + x * x);
  case operation::atan2: return (y * a.error + x * b.error) / (x * x + y * y);
  case operation::sin:
  case operation::cos: {
    const double slope = op == operation::sin ? elementary::cos(a.value) : elementary::sin(a.value);
    return numeric::equal(a.error, 0.0) ? 0 : (std::abs(slope) + a.error) * a.error;
  }
  case operation::tan: return (1 + value * value) * a.error;
  case operation::exp: return std::abs(value) * a.error;
  case operation::log: return a.error / (x - a.error);
  case operation::power:
    if (numeric::equal(x, 0.0)) return numeric::equal(a.error, 0.0) ? 0 : std::pow(a.error, b.value);
    return std::abs(value) * (y * a.error / x + std::abs(std::log(x)) * b.error);
  case operation::sign: return !numeric::equal(a.value, 0.0) && a.vanishes() ? 1 : 0;
  default: return a.error;
  }
}

} // namespace detail

inline bounded apply(operation op, const bounded& a, const bounded& b) {
  const auto is_nothing = [](const bounded& x) {
    return numeric::equal(x.value, 0.0) && numeric::equal(x.error, 0.0);
  };
  if (op == operation::multiply && (is_nothing(a) || is_nothing(b))) return {}; // as in the graph
  if (!a.defined() || !b.defined() || is_singular(op, a, b)) return bounded::undefined();
  const double value = value_of(op, a.value, b.value);
  return bounded::rounded(value, detail::carried_error(op, a, b, value));
}
inline bounded operator-(const bounded& a, const bounded& b) { return apply(operation::subtract, a, b); }
inline bounded operator*(const bounded& a, const bounded& b) { return apply(operation::multiply, a, b); }
inline bounded operator/(const bounded& a, const bounded& b) { return apply(operation::divide, a, b); }

} // namespace kanexpr::symbolic::taylor
