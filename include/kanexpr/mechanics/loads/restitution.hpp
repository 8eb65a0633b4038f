#pragma once

#include <kanexpr/numeric/beams/gauss_legendre.hpp>

/// The damping of a contact for a given coefficient of restitution.
namespace kanexpr::mechanics {

namespace detail {

/// The value of `dissipation_factor` (one_sided.hpp) at c δ̇ = x.
constexpr double dissipation_at(double x) {
  const double t = 2 * x + 2.5;
  return t <= 0 ? 0 : t < 1 ? t * t * t * (1 - t / 2) / 2 : 1 + x;
}

/// The integral of x/h(x), where h is the dissipation factor, over intervals that are short compared with
/// the distance to its pole at −5/4.
class dissipated_work {
public:
  constexpr explicit dissipated_work(int points) : rule_(numeric::beams::gauss_legendre(points)) {}

  /// From −e x to x.
  constexpr double over(double e, double x) const {
    double sum = 0;
    for (double at = 0; at < x;) at = add(sum, at, next(at, x));
    for (double at = 0; at > -e * x;) at = add(sum, at, next_below(at, -e * x));
    return sum;
  }

private:
  static constexpr double smaller(double a, double b) { return a < b ? a : b; }
  static constexpr double next(double at, double end) { return smaller(2 * at + 0.5, end); }
  /// Downward: to the edge of the blend at −3/4, and then halfway to the pole.
  static constexpr double next_below(double at, double end) {
    const double to = at > -0.75 ? -0.75 : (at - 1.25) / 2;
    return to > end ? to : end;
  }
  constexpr double add(double& sum, double from, double to) const {
    double part = 0;
    for (int i = 0; i < rule_.size(); ++i) {
      const double x = from + (to - from) * rule_.nodes[i];
      part += rule_.weights[i] * x / dissipation_at(x);
    }
    sum += part * (to > from ? to - from : from - to);
    return to;
  }

  numeric::beams::quadrature rule_;
};

} // namespace detail

/// The product c v of the damping c and the approach speed v for which the force F(δ) h(c δ̇) of a contact has
/// the coefficient of restitution e; 0 if e is not in (0, 1). Below e = 1e-12, it is that of 1e-12.
///
/// The body of mass m that meets the contact moves with m y dy = −F(δ) h(c y) dδ, where y = δ̇. The
/// penetration δ begins and ends at 0, so the integral of y/h(c y) from −e v to v vanishes, whatever F and m
/// are. For h = 1 + c y this is ln(1 + c v) − c v = ln(1 − c e v) + c e v. Weight and other forces during the
/// impact are neglected.
constexpr double damping_of_restitution(double e) {
  if (!(e > 0 && e < 1)) return 0;
  int points = 16; // not const, because g++ would then form the rule in every file
  const detail::dissipated_work work(points);
  if (e < 1e-12) e = 1e-12;
  double least = 0, most = 1.25 / e;
  for (int i = 0; i < 60; ++i) {
    const double middle = (least + most) / 2;
    (work.over(e, middle) > 0 ? least : most) = middle;
  }
  return (least + most) / 2;
}

} // namespace kanexpr::mechanics
