#pragma once

#include <kanexpr/simulate/surroundings.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::simulated {

/// ∂r/∂x of a controller, by central differences: its function is not known but by its values.
template <class System>
class input_sensitivity {
public:
  static constexpr int entries = kanexpr::state<System>::coordinates + kanexpr::state<System>::speeds;
  using matrix = Eigen::Matrix<double, compiled::survey_of<System>.inputs, entries>;

  /// At the state where the surroundings stand.
  answer find(double t, surroundings<System>& around) {
    if (!around.source().depends_on_state()) return answer::given;
    const kanexpr::state<System> x = around.x();
    for (int j = 0; j < entries; ++j) {
      const double step = relative_step * (std::max)(around.sizes()(j), std::abs(x(j)));
      for (const double side : {1.0, -1.0}) {
        kanexpr::state<System> beside = x;
        beside(j) += side * step;
        if (const answer a = around.take(t, beside); a != answer::given) return a;
        if (side > 0)
          by_state_.col(j) = around.r();
        else
          by_state_.col(j) -= around.r();
      }
      by_state_.col(j) /= 2 * step;
    }
    return around.take(t, x);
  }
  const matrix& by_state() const { return by_state_; }

private:
  static inline const double relative_step = std::cbrt(std::numeric_limits<double>::epsilon());

  matrix by_state_ = matrix::Zero();
};

} // namespace kanexpr::simulated
