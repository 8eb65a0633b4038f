#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Functions written in terms of others; the graph contains only those others.
namespace kanexpr::symbolic {

/// √(x² + y²). The squares may overflow, as they may in the magnitude of a vector.
constexpr expression hypot(expression x, expression y) { return sqrt(sum_of_products(x, x, y, y)); }

/// `positive` if the condition is positive, otherwise `other`; NaN if the condition is NaN. Neither the
/// branch that is not selected nor its derivative affects the result, even if it is undefined.
constexpr expression if_positive(expression condition, expression positive, expression other) {
  if (positive == other) return other;
  const expression first = selected(operation::if_positive, condition, positive);
  return first + selected(operation::if_not_positive, condition, other);
}

/// The smaller of two expressions: b if they are equal, NaN if either is NaN.
constexpr expression(min)(expression a, expression b) { return if_positive(b - a, a, b); }
/// The larger of two expressions: b if they are equal, NaN if either is NaN.
constexpr expression(max)(expression a, expression b) { return if_positive(a - b, a, b); }
/// Whether both bounds are constants and the first exceeds the second.
constexpr bool are_reversed(expression lower, expression upper) {
  if (!lower.is_constant() || !upper.is_constant()) return false;
  const graph& g = lower.owner();
  return g.number_at(lower.node()).value() > g.number_at(upper.node()).value();
}
/// Returns x limited to an interval.
constexpr expression clamp(expression x, expression lower, expression upper) {
  if (!__builtin_is_constant_evaluated() && x.is_given() && are_reversed(lower, upper))
    x.owner().record_reversed_bounds();
  return (min)((max)(x, lower), upper);
}

/// x tanh(x/width): |x| with a rounded corner, at most 0.28 width below |x|, and zero at zero.
constexpr expression smooth_abs(expression x, expression width) { return x * tanh(x / width); }

/// width ln(1 + e^(x/width)): max(x, 0) with a rounded corner, at most 0.7 width above max(x, 0). The
/// exponent is never positive; both branches have equal derivatives where they meet.
constexpr expression softplus(expression x, expression width) {
  const expression exponent = if_positive(x, -x, x), above_zero = selected(operation::if_positive, x, x);
  return above_zero + width * log(exp(exponent / width) + 1);
}

/// Rises from 0 at `from` to 1 at `to` with continuous second derivatives and is constant outside this
/// interval: t³ (6 t² − 15 t + 10), where t is the fraction of this interval below x.
constexpr expression smooth_step(expression x, expression from, expression to) {
  const expression zero = x.number(exactly(0)), one = x.number(exactly(1));
  const expression distance = x - from, t = clamp(distance / (to - from), zero, one), cube = t * t * t;
  return cube * (t * (6 * t - 15) + 10);
}

} // namespace kanexpr::symbolic
