#pragma once

#include "bicycle.hpp"

#include <algorithm>

/// The torque about the steering axis that keeps the bicycle upright at 1 to 6 m/s: a feedback of lean, steer
/// and their rates by gains that are interpolated along the speed. They are those of the linear-quadratic
/// regulator with the weights 10, 1, 1, 0.1 of the state and 0.01 of the torque.
struct program : embedded::bicycle::calls {
  static constexpr std::size_t found = 1;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    static constexpr T K[6][4]{{T(-247.16230407), T(10.46987659), T(-78.85115822), T(2.83307228)},
                               {T(-95.49432149), T(23.79425259), T(-29.63391398), T(3.67562528)},
                               {T(-64.18368848), T(30.20815726), T(-18.88235517), T(3.6309918)},
                               {T(-53.32570935), T(35.55076882), T(-14.7262877), T(3.50800468)},
                               {T(-48.01566321), T(40.50690604), T(-12.40437294), T(3.37690288)},
                               {T(-44.85276416), T(45.1131453), T(-10.82719373), T(3.24562872)}};
    const embedded::arguments<embedded::bicycle::BoundSystem, T> at(given);
    const Eigen::Matrix<T, 4, 1> measured{at.x(1), at.x(2), at.x(4), at.x(6)};         // q2, q5, u2, u5
    const T speed = at.x(5) * T(0.3), along = embedded::within(speed - 1, T(0), T(5)); // along the table
    const int row = std::min(static_cast<int>(along), 4);
    const T* const below = K[row];
    const T* const above = K[row + 1];
    T torque = 0;
    for (int i = 0; i < 4; ++i) torque -= (below[i] + (along - T(row)) * (above[i] - below[i])) * measured(i);
    *found = torque;
  }
};
