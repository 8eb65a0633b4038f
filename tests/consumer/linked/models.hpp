#pragma once

#include <kanexpr/joints.hpp>

/// A pendulum described by its joint, and one described by the position of its bob, which is constrained to a
/// circle.
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

struct Bob : pin<Bob, frame_and_point<N, O>, axis<N::z>, by<q, u>, body<2, l * own::x>> {};
struct Turning
    : kane_system<inertial<N>, joints<Bob>, inputs<T>, loads<gravity<9.81 * N::x>, motor<Bob, T>>> {};

struct Q : offset<Q, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, Q, 2> {};
struct Sliding
    : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>, kinematics<dot(x) == vx, dot(y) == vy>,
                  configuration_constraints<x * x + y * y == l * l>, dependent<x, vx>, bodies<Bead>,
                  loads<gravity<9.81 * N::x>>> {};

/// The first pendulum, by its Lagrangian.
constexpr parameter<"m"> m;
struct Given : lagrange_system<inertial<N>, coordinates<q>, parameters<l, m>,
                               lagrangian<m * l * l * dot(q) * dot(q) / 2 + m * 9.81 * l * cos(q)>> {};

/// A pendulum whose mass is an expression.
struct Lump : pin<Lump, frame_and_point<N, O>, axis<N::z>, by<q, u>, body<m - 1, l * own::x>> {};
struct Heavy : kane_system<inertial<N>, joints<Lump>, parameters<l, m>, loads<gravity<9.81 * N::x>>> {};

} // namespace models
