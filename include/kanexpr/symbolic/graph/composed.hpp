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
/// branch that is not selected nor its derivative has an effect, even if it is undefined.
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
constexpr bool is_out_of_order(expression least, expression most) {
  if (!least.is_constant() || !most.is_constant()) return false;
  const graph& g = least.owner();
  return g.number_at(least.node()).value() > g.number_at(most.node()).value();
}
/// Returns x limited to an interval.
constexpr expression clamp(expression x, expression least, expression most) {
  if (!__builtin_is_constant_evaluated() && x.is_given() && is_out_of_order(least, most))
    x.owner().note_limits_out_of_order();
  return (min)((max)(x, least), most);
}

/// x tanh(x/width): |x| with a rounded corner, at most 0.28 width below |x|, and zero at zero.
constexpr expression smooth_abs(expression x, expression width) { return x * tanh(x / width); }

/// width ln(1 + e^(x/width)): max(x, 0) with a rounded corner, at most 0.7 width above max(x, 0). The
/// exponent is never positive; both branches have equal derivatives where they meet.
constexpr expression softplus(expression x, expression width) {
  const expression least = if_positive(x, -x, x), above_zero = selected(operation::if_positive, x, x);
  return above_zero + width * log(exp(least / width) + 1);
}

/// Rises from 0 at `from` to 1 at `to` with continuous second derivatives and is constant beyond: t³ (6 t² −
/// 15 t + 10), where t is the fraction of the distance covered.
constexpr expression smooth_step(expression x, expression from, expression to) {
  const expression zero = x.number(exactly(0)), one = x.number(exactly(1));
  const expression gone = x - from, t = clamp(gone / (to - from), zero, one), cube = t * t * t;
  return cube * (t * (6 * t - 15) + 10);
}

} // namespace kanexpr::symbolic
