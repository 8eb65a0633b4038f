#include "models/simple_pendulum.hpp"

#include <kanexpr/fixed_step.hpp>

/// One step of the pendulum by the classic Runge-Kutta method; says whether it could be made.
extern "C" bool pendulum_step(float* t, float* x, float h, const float* p, const float* r) {
  using System = simple_pendulum::System;
  kanexpr::state<System, float> now(x[0], x[1]);
  const kanexpr::status made = kanexpr::runge_kutta_4<System>{}(
      *t, now, h, Eigen::Map<const Eigen::Vector4f>(p), Eigen::Map<const Eigen::Matrix<float, 1, 1>>(r));
  x[0] = now(0);
  x[1] = now(1);
  return static_cast<bool>(made);
}
