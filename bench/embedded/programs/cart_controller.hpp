#pragma once

#include "call.hpp"

#include <controllers/balanced_cart.hpp>

#include <array>

/// The force that keeps the pendulum of the cart upright, from what its sensors say: an update of the Kalman
/// filter, the feedback, and the filter's prediction. It is given the estimate, what the sensors say, and the
/// covariance of the estimate.
struct program {
  static constexpr std::array<double, 22> given{0.2,    balanced_cart::upright + 0.1,
                                                -0.3,   0.4,
                                                0.21,   balanced_cart::upright + 0.08,
                                                1.4e-6, 7e-7,
                                                4.5e-6, 3.4e-6,
                                                7e-7,   4.5e-6,
                                                6.2e-6, 2.3e-5,
                                                4.5e-6, 6.2e-6,
                                                9.3e-5, 8e-5,
                                                3.4e-6, 2.3e-5,
                                                8e-5,   1.9e-4};
  static constexpr std::size_t varied = 6, found = 22;
  static constexpr double spread = 0.3;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    using controller = balanced_cart::controller<T>;
    const Eigen::Map<const Eigen::Matrix<T, 4, 1>> estimate(given);
    const Eigen::Map<const Eigen::Matrix<T, 2, 1>> seen(given + 4);
    const Eigen::Map<const Eigen::Matrix<T, 4, 4>> covariance(given + 6);
    controller control(typename controller::state(estimate), covariance);
    const kanexpr::status made = control(seen);
    T* const rest = embedded::put(embedded::put(found, control.force), control.estimate.x);
    *embedded::put(rest, control.estimate.P) = embedded::as_number<T>(made);
  }
};
