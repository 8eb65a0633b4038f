#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

/// A one-sided elastic law that is smooth: no force at a distance, no tension, and no energy created.
///
/// With t = x/w limited to [0, 1], g(x) = w t³ (1 − t/2) + max(x − w, 0): zero for x ≤ 0, x − w/2 for x ≥ w,
/// and with continuous second derivatives everywhere.
namespace kanexpr::mechanics {

/// g(x), with the width w over which it is rounded. The rounded part is selected at x = w itself, where its
/// derivatives are those of both sides.
constexpr expression one_sided(expression x, expression width) {
  const expression zero = x.number(symbolic::exactly(0)), half = width / 2;
  const expression t = (symbolic::max)(x / width, zero), cube = t * t * t;
  const expression rounded = width * (cube * (1 - t / 2));
  return symbolic::if_positive(x - width, x - half, rounded);
}

/// The integral of g from 0 to x: w² (t⁴/4 − t⁵/10) up to x = w, and (x − w/2)²/2 + w²/40 beyond.
constexpr expression one_sided_energy(expression x, expression width) {
  const expression zero = x.number(symbolic::exactly(0)), half = width / 2, area = width * width;
  const expression t = (symbolic::max)(x / width, zero), square = t * t;
  const expression rounded = area * (square * square * (5 - 2 * t) / 20);
  const expression beyond = x - half, energy = beyond * beyond / 2 + area / 40;
  return symbolic::if_positive(x - width, energy, rounded);
}

/// The factor of an elastic force by Hunt & Crossley (1975), doi 10.1115/1.3423596, 1 + c v, without the
/// tension that it predicts for fast separation: g(1/4 + 1 + c v) with a width of 1/2. It equals 1 + c v if c
/// v ≥ −3/4, and 0 if c v ≤ −5/4. It increases with v and is exactly 1 at v = 0, so the force minus its
/// elastic part always opposes the motion, whatever the motion is.
constexpr expression dissipation_factor(expression damping, expression approach) {
  const expression shift = damping.number(symbolic::exactly(5, 4));
  return one_sided(damping * approach + shift, damping.number(symbolic::exactly(1, 2)));
}

} // namespace kanexpr::mechanics
