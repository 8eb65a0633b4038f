#pragma once

#include "call.hpp"

#include <models/simple_pendulum.hpp>

#include <array>

/// A pendulum with a motor that is limited and weakens with its speed, and a stop, where its programs are
/// called.
namespace embedded::servo {

using namespace simple_pendulum;

constexpr parameter<"k"> k;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<m, l, g, c, k>, inputs<T>, bodies<Bob>,
                            loads<gravity<g * N::x>, torque<A, clamp(T - c * u, -1, 1) * N::z>,
                                  torque<A, tabulated<0, 3, 2, 2.5, 4, 1, 5, 0>(abs(u)) * N::z>,
                                  torque<A, if_positive(q - 0.5, k * (0.5 - q), 0) * N::z>>> {};

struct calls {
  using system = System;
  static constexpr std::array<double, 8> given{0.3, -0.4, 0.5, 2,
                                               0.5, 9.81, 0.1, 40}; // q, u; T; m, l, g, c, k
  static constexpr std::size_t varied = 3;
  static constexpr double spread = 3;
};

} // namespace embedded::servo
