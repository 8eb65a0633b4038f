#pragma once

#include "call.hpp"

#include <kanexpr/beams.hpp>

#include <array>

/// A motor with a flexible arm, where its programs are called.
namespace embedded::arm {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"J"> J;
constexpr parameter<"L"> L;
constexpr parameter<"rho"> rho;
constexpr parameter<"EI"> EI;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct Hub : rotated<Hub, N, q, N::z> {};
struct O : origin<O, N> {};
struct Motor : rigid_body<Motor, O, Hub, 1, inertia<Hub, J, J, J>> {};
struct Arm : beam<Arm, O, Hub::x, L, rho, bending<Hub::y, EI, clamped_free<2>>, modal_damping<0.01>> {};
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<J, L, rho, EI>,
                  inputs<T>, bodies<Motor, Arm>, loads<torque<Hub, T * N::z>>> {};

struct calls {
  using system = System;
  static constexpr std::array<double, 11> given{0.3, 0.02, -0.01, -0.4, 0.1, 0.2,
                                                0.5, 0.1,  1,     0.5,  20}; // q, u; T; J, L, rho, EI
  static constexpr std::size_t varied = 7;
  static constexpr double spread = 0.01;
};

} // namespace embedded::arm
