#pragma once

#include "iiwa.hpp"

/// The torques of the iiwa that let its joints follow a motion (computed torque). The accelerations are those
/// that bring the error back by e'' + 20 e' + 100 e = 0. What is wanted comes with the state: the angles and
/// speeds are zero, the accelerations stand where the torques do.
struct program : embedded::iiwa::calls {
  using system = embedded::iiwa::System;
  using eom = kanexpr::equations_of_motion<system>;
  static constexpr std::size_t found = eom::speeds;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    Eigen::Matrix<T, eom::speeds, 1> a;
    for (int i = 0; i < eom::speeds; ++i) a(i) = at.r(i) - 20 * at.x(eom::coordinates + i) - 100 * at.x(i);
    embedded::put(found, eom::required_inputs(at.x, at.p, at.r, a));
  }
};
