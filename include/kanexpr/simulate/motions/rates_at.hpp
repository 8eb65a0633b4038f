#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulate/motions/simulation_context.hpp>

namespace kanexpr::simulated {

/// Evaluates the rates of a state with the inputs at that time and state; returns false if they cannot be
/// evaluated.
inline bool rates_at(surroundings& around, double t, const Eigen::VectorXd& x, Eigen::VectorXd& rates) {
  if (around.take(t, x) != answer::given) return false;
  rates.resize(x.size());
  return static_cast<bool>(around.rates(t, rates.data())) && numeric::all_finite(rates);
}

} // namespace kanexpr::simulated
