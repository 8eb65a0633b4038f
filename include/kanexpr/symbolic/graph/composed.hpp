#pragma once

#include <kanexpr/symbolic/graph/functions.hpp>

/// Functions that are written with others: the graph has only what they are made of.
namespace kanexpr::symbolic {

/// √(x² + y²). The squares may overflow, as those of a vector's magnitude may.
constexpr expression hypot(expression x, expression y) { return sqrt(sum_of_products(x, x, y, y)); }

/// `positive` where the condition is positive, else `other`; not-a-number where the condition is none. What
/// is not chosen does not matter, even where it has no value, nor does its derivative.
constexpr expression if_positive(expression condition, expression positive, expression other) {
  if (positive == other) return other;
  const expression first = selected(operation::if_positive, condition, positive);
  return first + selected(operation::if_not_positive, condition, other);
}

/// The smaller one; where both are equal the second, and not-a-number where one of them is none.
constexpr expression(min)(expression a, expression b) { return if_positive(b - a, a, b); }
/// The larger one, likewise.
constexpr expression(max)(expression a, expression b) { return if_positive(a - b, a, b); }
/// Whether two limits are numbers of which the first is larger.
constexpr bool is_out_of_order(expression least, expression most) {
  if (!least.is_constant() || !most.is_constant()) return false;
  const graph& g = least.owner();
  return g.number_at(least.node()).value() > g.number_at(most.node()).value();
}
/// x between two bounds; where it meets one, that bound.
constexpr expression clamp(expression x, expression least, expression most) {
  if (!__builtin_is_constant_evaluated() && x.is_given() && is_out_of_order(least, most))
    x.owner().note_limits_out_of_order();
  return (min)((max)(x, least), most);
}

/// x tanh(x/width): |x| with its corner rounded, at most 0.28 width below it, and zero at zero.
constexpr expression smooth_abs(expression x, expression width) { return x * tanh(x / width); }

/// width ln(1 + e^(x/width)): max(x, 0) with its corner rounded, at most 0.7 width above it. Of the two
/// exponentials the one that is at most 1 is taken; both branches have the same derivatives where they meet.
constexpr expression softplus(expression x, expression width) {
  const expression least = if_positive(x, -x, x), above_zero = selected(operation::if_positive, x, x);
  return above_zero + width * log(exp(least / width) + 1);
}

/// From 0 at `from` to 1 at `to`, with continuous second derivatives, and constant beyond:
/// t³ (6 t² − 15 t + 10) of the part t of the way.
constexpr expression smooth_step(expression x, expression from, expression to) {
  const expression zero = x.number(exactly(0)), one = x.number(exactly(1));
  const expression gone = x - from, t = clamp(gone / (to - from), zero, one), cube = t * t * t;
  return cube * (t * (6 * t - 15) + 10);
}

} // namespace kanexpr::symbolic
