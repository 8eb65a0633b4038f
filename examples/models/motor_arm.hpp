#pragma once

#include <kanexpr/kanexpr.hpp>

/// An arm that a DC motor turns through a gear. A PI controller with a filtered reference sets the voltage.
/// The current, the filter and the integrator have rates of their own.
namespace motor_arm {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q", radian> q;
constexpr speed<"u"> u;
constexpr state_variable<"i", ampere> i;        // the current
constexpr state_variable<"f", radian> filtered; // the reference behind the filter
constexpr state_variable<"e"> integral;         // of the deviation
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"n", dimensionless> n;           // gear ratio
constexpr parameter<"k", newton * meter / ampere> k; // torque per current, and voltage per angular velocity
constexpr parameter<"R", ohm> R;
constexpr parameter<"L", henry> L;
constexpr parameter<"kp", volt / radian> kp;
constexpr parameter<"ki", volt / radian / second> ki;
constexpr parameter<"tau", second> tau;
constexpr input<"r", radian> reference;

constexpr auto voltage = kp * (filtered - q) + ki * integral;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};

using motor_and_controller =
    dynamics<L * dot(i) == voltage - R * i - n * k * u, tau * dot(filtered) == reference - filtered,
             dot(integral) == filtered - q>;

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, states<i, filtered, integral>,
                  parameters<m, l, g, n, k, R, L, kp, ki, tau>, inputs<reference>, kinematics<dot(q) == u>,
                  motor_and_controller, bodies<Bob>, loads<gravity<g * N::x>, torque<A, n * k * i * N::z>>> {
};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q>, states<i, filtered, integral>,
                      parameters<m, l, g, n, k, R, L, kp, ki, tau>, inputs<reference>,
                      dynamics<L * dot(i) == voltage - R * i - n * k * dot(q),
                               tau * dot(filtered) == reference - filtered, dot(integral) == filtered - q>,
                      bodies<Bob>, loads<gravity<g * N::x>, torque<A, n * k * i * N::z>>> {};

} // namespace motor_arm
