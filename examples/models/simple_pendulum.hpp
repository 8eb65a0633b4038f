#pragma once

#include <kanexpr/kanexpr.hpp>

/// A bob on a massless rod, with viscous friction and a motor at the pivot. It hangs straight down at q = 0.
namespace simple_pendulum {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q", radian> q;
constexpr speed<"u"> u;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * meter * second / radian> c;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};

struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};

struct Bob : particle<Bob, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  inputs<T>, bodies<Bob>, loads<gravity<g * N::x>, torque<A, (T - c * u) * N::z>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q>, parameters<m, l, g, c>, inputs<T>, bodies<Bob>,
                      loads<gravity<g * N::x>, torque<A, (T - c * dot(q)) * N::z>>> {};

} // namespace simple_pendulum
