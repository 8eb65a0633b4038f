#pragma once

#include <kanexpr/simulate.hpp>
#include <models/bicycle.hpp>
#include <models/double_pendulum.hpp>
#include <models/simple_pendulum.hpp>

#include <cmath>

/// Motions to be measured: a system, the state it starts from, which may be changed a little, its parameters
/// and inputs, and the time span.
namespace motions {

using kanexpr::input_values;
using kanexpr::parameter_values;
using kanexpr::state;
using kanexpr::time_span;

/// The benchmark bicycle, upright at 4.6 m/s, after a push to the side that dies out.
struct bicycle {
  using System = ::bicycle::BoundSystem;
  static constexpr time_span span{0, 10};

  static state<System> start(double change = 0) {
    constexpr double rear_radius = 0.3;
    state<System> x;
    x[::bicycle::u2] = 0.5 + change;
    x[::bicycle::u3] = 4.6 / rear_radius;
    return x;
  }
  static parameter_values<System> parameters() { return {}; }
  static void give_inputs(double, const state<System>&, input_values<System>&) {}
};

/// Two bars that swing high and lose nothing.
struct double_pendulum {
  using System = ::double_pendulum::System;
  static constexpr time_span span{0, 10};

  static state<System> start(double change = 0) {
    state<System> x;
    x[::double_pendulum::q1] = 0.5 + change;
    x[::double_pendulum::q2] = 0.3;
    return x;
  }
  static parameter_values<System> parameters() {
    using namespace ::double_pendulum;
    parameter_values<System> p;
    p[m1] = 1, p[d1] = 0.5, p[l1] = 1, p[I1] = 0.1, p[c1] = 0;
    p[m2] = 1.2, p[d2] = 0.5, p[I2] = 0.1, p[c2] = 0;
    p[g] = 9.81;
    return p;
  }
  static void give_inputs(double, const state<System>&, input_values<System>& r) { r.setZero(); }
};

/// A pendulum that a controller of high gain leads along a slow swing. It follows within a millisecond, so
/// that an explicit method would need steps of that size.
struct led_pendulum {
  using System = ::simple_pendulum::System;
  static constexpr time_span span{0, 10};

  static state<System> start(double change = 0) {
    state<System> x;
    x[::simple_pendulum::q] = change;
    return x;
  }
  static parameter_values<System> parameters() {
    using namespace ::simple_pendulum;
    parameter_values<System> p;
    p[m] = 1, p[l] = 1, p[g] = 9.81, p[c] = 1e3;
    return p;
  }
  static void give_inputs(double t, const state<System>& x, input_values<System>& r) {
    using namespace ::simple_pendulum;
    constexpr double gain = 1e5;
    r[T] = gain * (std::sin(t) - x[q]);
  }
};

} // namespace motions
