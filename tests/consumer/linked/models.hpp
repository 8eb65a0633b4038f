#pragma once

#include <kanexpr/describe.hpp>

/// A pendulum by its angle, and one by the place of its bob, which a constraint holds on a circle.
namespace models {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"u"> u;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr parameter<"l"> l;
constexpr input<"T"> T;

struct N : inertial_frame<N> {}; // x points down
struct O : origin<O, N> {};

struct A : rotated<A, N, q, N::z> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, 2> {};
struct Turning : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, inputs<T>,
                             bodies<Bob>, loads<gravity<9.81 * N::x>, torque<A, T * N::z>>> {};

struct Q : offset<Q, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, Q, 2> {};
struct Sliding
    : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>, kinematics<dot(x) == vx, dot(y) == vy>,
                  configuration_constraints<x * x + y * y == l * l>, dependent<x, vx>, bodies<Bead>,
                  loads<gravity<9.81 * N::x>>> {};

/// The first of them by its Lagrangian.
constexpr parameter<"m"> m;
struct Given : lagrange_system<inertial<N>, coordinates<q>, parameters<l, m>,
                               lagrangian<m * l * l * dot(q) * dot(q) / 2 + m * 9.81 * l * cos(q)>> {};

} // namespace models
