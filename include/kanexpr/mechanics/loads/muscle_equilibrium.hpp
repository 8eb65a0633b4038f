#pragma once

#include <kanexpr/mechanics/loads/muscle_parameters.hpp>
#include <kanexpr/numeric/muscle_curves.hpp>

#include <cmath>
#include <limits>

namespace kanexpr {

/// The state of a muscle whose fibers are at rest.
struct muscle_at_rest {
  double tendon_force = 0; ///< relative to the peak isometric force, as the state variable `tendon_force`
  double fiber_length = 0; ///< relative to the optimal fiber length, as the state variable `fiber_length`
};

namespace mechanics {

/// The equilibrium of a muscle with its tendon, whose length is found by bisection.
class muscle_balance {
public:
  template <class... Values>
  muscle_balance(const muscle_parameters<Values...>& of, double length, double activation)
      : optimal_(of.optimal_fiber_length), slack_(of.tendon_slack_length),
        width_(optimal_ * std::sin(of.pennation)), tendon_strain_(of.tendon_strain),
        passive_strain_(of.passive_strain), length_(length), activation_(activation) {}

  muscle_at_rest solve() const {
    double shorter = 0.95 * slack_, longer = length_;
    if (!(shorter < longer) || excess(longer) < 0 || excess(shorter) > 0)
      return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (shorter + longer);
      (excess(middle) < 0 ? shorter : longer) = middle;
    }
    return {force_of_tendon(longer), fibers_with(longer)};
  }

private:
  double fibers_with(double tendon) const { return std::hypot(length_ - tendon, width_) / optimal_; }
  double force_of_tendon(double tendon) const {
    return numeric::muscle_curves::tendon_force(tendon / slack_, tendon_strain_);
  }
  /// The force of the tendon minus that of the fibers along it.
  double excess(double tendon) const {
    namespace curves = numeric::muscle_curves;
    const double fibers = fibers_with(tendon), cosine = (length_ - tendon) / (fibers * optimal_);
    const double active = activation_ * curves::active_force(fibers) * curves::velocity_force(0.0);
    const double force = (active + curves::passive_force(fibers, passive_strain_)) * cosine;
    return force_of_tendon(tendon) - (fibers > 0 ? force : 0);
  }

  double optimal_, slack_, width_, tendon_strain_, passive_strain_, length_, activation_;
};

} // namespace mechanics

/// The state in which the fibers of a muscle with an elastic tendon are at rest, at a given length of the
/// pathway in m and a given activation. The parameters must be numbers. The results are NaN if the pathway is
/// too short to stretch the tendon.
template <class... Values>
muscle_at_rest muscle_equilibrium(const muscle_parameters<Values...>& of, double length, double activation) {
  return mechanics::muscle_balance(of, length, activation).solve();
}

} // namespace kanexpr
