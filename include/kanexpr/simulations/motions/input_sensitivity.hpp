#pragma once

#include <kanexpr/simulations/motions/simulation_context.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::simulations {

/// ∂r/∂x of a controller by central differences, since only the values of its function are available.
class input_sensitivity {
public:
  using vector = Eigen::VectorXd;

  explicit input_sensitivity(const simulation_context& context)
      : by_state_(Eigen::MatrixXd::Zero(context.known().inputs, context.system().states())) {}

  /// Evaluates the derivatives at the current state of the context.
  answer find(double t, simulation_context& context) {
    if (!context.inputs_depend_on_state()) return answer::success;
    const vector x = context.x();
    for (int j = 0; j < x.size(); ++j) {
      const double step = relative_step * (std::max)(context.sizes()(j), std::abs(x(j)));
      for (const double side : {1.0, -1.0}) {
        vector nearby = x;
        nearby(j) += side * step;
        if (const answer a = context.set_state(t, nearby); a != answer::success) return a;
        for (int i = 0; i < context.known().inputs; ++i)
          by_state_(i, j) = side > 0 ? context.r()(i) : (by_state_(i, j) - context.r()(i)) / (2 * step);
      }
    }
    return context.set_state(t, x);
  }
  const Eigen::MatrixXd& by_state() const { return by_state_; }

private:
  static inline const double relative_step = std::cbrt(std::numeric_limits<double>::epsilon());

  Eigen::MatrixXd by_state_;
};

} // namespace kanexpr::simulations
