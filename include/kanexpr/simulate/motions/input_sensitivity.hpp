#pragma once

#include <kanexpr/simulate/motions/simulation_context.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::simulated {

/// ∂r/∂x of a controller by central differences, since only the values of its function are available.
class input_sensitivity {
public:
  using vector = Eigen::VectorXd;

  explicit input_sensitivity(const surroundings& around)
      : by_state_(Eigen::MatrixXd::Zero(around.known().inputs, around.system().states())) {}

  /// Evaluates the derivatives at the current state of the surroundings.
  answer find(double t, surroundings& around) {
    if (!around.inputs_depend_on_state()) return answer::given;
    const vector x = around.x();
    for (int j = 0; j < x.size(); ++j) {
      const double step = relative_step * (std::max)(around.sizes()(j), std::abs(x(j)));
      for (const double side : {1.0, -1.0}) {
        vector beside = x;
        beside(j) += side * step;
        if (const answer a = around.take(t, beside); a != answer::given) return a;
        for (int i = 0; i < around.known().inputs; ++i)
          by_state_(i, j) = side > 0 ? around.r()(i) : (by_state_(i, j) - around.r()(i)) / (2 * step);
      }
    }
    return around.take(t, x);
  }
  const Eigen::MatrixXd& by_state() const { return by_state_; }

private:
  static inline const double relative_step = std::cbrt(std::numeric_limits<double>::epsilon());

  Eigen::MatrixXd by_state_;
};

} // namespace kanexpr::simulated
