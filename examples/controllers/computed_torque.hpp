#pragma once

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/numeric/as_eigen.hpp>
#include <models/iiwa.hpp>

#include <cmath>

/// The joints of an iiwa follow a motion from one posture to another, from any initial state. The torques are
/// those for the accelerations that make the error e decay according to e'' + damping e' + stiffness e = 0.
namespace computed_torque {

using namespace iiwa;
using eom = equations_of_motion<System>;

template <class T>
using joints = Eigen::Matrix<T, eom::coordinates, 1>;

constexpr double period = 0.001, stiffness = 100, damping = 20; // s, 1/s², 1/s: both poles at −10/s

constexpr double duration = 2; // s
constexpr numeric::fixed_matrix<double, 7, 1> begin{{0, -0.6, 0, 1.4, 0, -1.0, 0}},
    end{{1.5, 0.7, -0.8, -1.2, 1.0, 0.9, 1.5}}; // rad

/// The desired motion of the joints at a time.
template <class T>
struct motion {
  joints<T> angles, speeds, accelerations;
};

/// The minimum-jerk polynomial: at rest before 0 and after the duration.
template <class T>
motion<T> motion_at(T t) {
  static constexpr auto from = begin.cast<T>(), way = (end - begin).template cast<T>();
  const T begun = t * T(1 / duration), s = (std::abs(begun) - std::abs(begun - 1) + 1) / 2; // from 0 to 1
  const T part = s * s * s * (10 - s * (15 - 6 * s));
  const T rate = T(30 / duration) * s * s * (1 - s) * (1 - s);
  const T acceleration = T(60 / (duration * duration)) * s * (1 - s) * (1 - 2 * s);
  return {numeric::as_eigen(from) + part * numeric::as_eigen(way), rate * numeric::as_eigen(way),
          acceleration * numeric::as_eigen(way)};
}

/// The torques until the next call, one period later, at the state x.
template <class T>
input_values<System, T> torques(T t, const state<System, T>& x) {
  const motion<T> wanted = motion_at(t);
  const joints<T> a =
      wanted.accelerations + T(damping) * (wanted.speeds - x.u()) + T(stiffness) * (wanted.angles - x.q());
  return eom::required_inputs(x, parameter_values<System, T>(), input_values<System, T>::Zero(), a);
}

} // namespace computed_torque
