#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulate/surroundings.hpp>

namespace kanexpr::simulated {

/// The rates of a state with the inputs of that time and state; false where there are none.
inline bool rates_at(surroundings& around, double t, const Eigen::VectorXd& x, Eigen::VectorXd& rates) {
  if (around.take(t, x) != answer::given) return false;
  rates.resize(x.size());
  return static_cast<bool>(around.rates(t, rates.data())) && numeric::all_finite(rates);
}

} // namespace kanexpr::simulated
