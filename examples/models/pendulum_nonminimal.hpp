#pragma once

#include <kanexpr/kanexpr.hpp>

/// A pendulum described by the two coordinates of its bob, which is constrained to a circle.
namespace pendulum_nonminimal {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", meter> q1;
constexpr coordinate<"q2", meter> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"L", meter> L;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // x points down

struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y> {};

struct Bob : particle<Bob, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q2, q1>, speeds<u2, u1>, kinematics<dot(q1) == u1, dot(q2) == u2>,
                  configuration_constraints<q1 * q1 + q2 * q2 == L * L>, dependent<q1, u1>, bodies<Bob>,
                  loads<gravity<g * N::x>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q2, q1>, configuration_constraints<q1 * q1 + q2 * q2 == L * L>,
                      dependent<q1, dot(q1)>, bodies<Bob>, loads<gravity<g * N::x>>> {};

} // namespace pendulum_nonminimal
