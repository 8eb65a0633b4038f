#pragma once

#include <Eigen/Core>

#include <cmath>

namespace kanexpr::simulations {

/// The tolerated errors of a step in the entries of a state.
struct tolerances {
  double relative = 0;
  Eigen::VectorXd absolute{};

  Eigen::VectorXd at(const Eigen::VectorXd& x) const {
    Eigen::VectorXd both(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) both(i) = relative * std::abs(x(i)) + absolute(i);
    return both;
  }
};

} // namespace kanexpr::simulations
