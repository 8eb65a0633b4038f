#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Interpolation of tables.
namespace kanexpr::symbolic {

namespace detail {

/// The points of a table, the lengths of its intervals and the slopes of its chords.
struct table_points {
  sequence<expression> x{}, y{}, length{}, slope{};

  constexpr table_points(const expression* given, int count) {
    for (int i = 0; i < count; ++i) {
      x.push(*given++);
      y.push(*given++);
    }
    for (int i = 0; i + 1 < count; ++i) {
      length.push(x[i + 1] - x[i]);
      slope.push((y[i + 1] - y[i]) / length[i]);
    }
  }
};

/// The slope at the point between two intervals: the weighted harmonic mean of the chord slopes, or zero if
/// their signs differ, so that the curve is monotone wherever its points are. Fritsch & Butland, A method for
/// constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984).
constexpr expression interior_slope(const table_points& p, int left_interval, int right_interval) {
  const expression left = 2 * p.length[right_interval] + p.length[left_interval],
                   right = p.length[right_interval] + 2 * p.length[left_interval];
  const expression product = p.slope[left_interval] * p.slope[right_interval],
                   zero = product.number(exactly(0));
  const expression above = (left + right) * product;
  const expression mean =
      above / sum_of_products(left, p.slope[right_interval], right, p.slope[left_interval]);
  return if_positive(product, mean, zero);
}

/// The slope at an end: the slope of the parabola through three points, limited to keep the curve monotone.
/// Moler, Numerical Computing with MATLAB (2004), section 3.6.
constexpr expression slope_at_end(const table_points& p, int first, int second) {
  const expression h = p.length[first], beside = p.length[second], s = p.slope[first];
  const expression above = difference_of_products(2 * h + beside, s, h, p.slope[second]);
  const expression parabola = above / (h + beside);
  const expression most = 3 * s, zero = s.number(exactly(0));
  const expression turns = s * p.slope[second], steepness = abs(parabola), excess = steepness - abs(most);
  const expression bounded = if_positive(turns, parabola, if_positive(excess, most, parabola));
  return if_positive(parabola * s, bounded, zero);
}

constexpr sequence<expression> monotone_slopes(const table_points& p) {
  const int last = p.x.size() - 1;
  sequence<expression> all;
  all.push(last == 1 ? p.slope[0] : slope_at_end(p, 0, 1));
  for (int i = 1; i < last; ++i) all.push(interior_slope(p, i - 1, i));
  all.push(last == 1 ? p.slope[0] : slope_at_end(p, last - 1, last - 2));
  return all;
}

/// The sum of the cubics of all intervals, with slopes d at the points. `excesses` contains the amounts by
/// which x exceeds each point except the last.
constexpr expression sum_of_rises(const table_points& p, const sequence<expression>& d,
                                  const sequence<expression>& excesses) {
  expression sum = p.y[0];
  for (int i = 0; i < excesses.size(); ++i) {
    const expression t = i + 1 < excesses.size() ? excesses[i] - excesses[i + 1] : excesses[i],
                     h = p.length[i];
    const expression thrice = 3 * p.slope[i], bend = (thrice - 2 * d[i] - d[i + 1]) / h,
                     ends = d[i] + d[i + 1], excess = ends - 2 * p.slope[i], twist = excess / (h * h);
    sum += t * (d[i] + t * (bend + t * twist));
  }
  return sum;
}

constexpr expression excess_over(expression x, expression point) {
  const expression rest = x - point;
  return selected(operation::if_positive, rest, rest);
}

} // namespace detail

/// A monotone cubic interpolant through two or more points x₀, y₀, x₁, y₁, … with increasing x, constant
/// beyond them. Each interval adds the rise of the curve within it, a cubic in the fraction t of the interval
/// that lies below x. Therefore no lookup is needed, and the derivatives are those of the cubics; at a point,
/// the derivatives are those of the interval before it.
constexpr expression tabulated(expression x, const expression* points, int count) {
  const detail::table_points p(points, count);
  const expression within = (min)(x, p.x.back());
  sequence<expression> excesses;
  for (int i = 0; i + 1 < count; ++i) excesses.push(detail::excess_over(within, p.x[i]));
  return detail::sum_of_rises(p, detail::monotone_slopes(p), excesses);
}

/// The periodic counterpart of `tabulated`: it repeats after the last point, which has the same value and
/// slope as the first. The position within the period is computed from the angle that corresponds to x, so
/// that no derivative jumps.
constexpr expression periodic(expression x, const expression* points, int count) {
  constexpr double whole_turn = 6.28318530717958647692;
  const detail::table_points p(points, count);
  const int last = count - 1;
  const expression middle = (p.x[0] + p.x[last]) / 2, turn = whole_turn / (p.x[last] - p.x[0]),
                   angle = turn * (x - middle), sine = sin(angle),
                   within = middle + atan2(sine, cos(angle)) / turn;
  sequence<expression> d, excesses;
  for (int i = 0; i <= last; ++i)
    d.push(detail::interior_slope(p, i == 0 ? last - 1 : i - 1, i == last ? 0 : i));
  excesses.push(within - p.x[0]);
  for (int i = 1; i < last; ++i) excesses.push(detail::excess_over(within, p.x[i]));
  return detail::sum_of_rises(p, d, excesses);
}

} // namespace kanexpr::symbolic
