#pragma once

#include <kanexpr/describe.hpp>

/// A pendulum on a cart that states the units of an angle, a mass and an input, from which all others follow
/// except that of w.
namespace pendulum_on_cart {

using namespace kanexpr;

constexpr coordinate<"s"> s;
constexpr coordinate<"q", units::si::radian> q;
constexpr speed<"v"> v;
constexpr speed<"u"> u;
constexpr parameter<"m", units::si::kilogram> m;
constexpr parameter<"l"> l;
constexpr parameter<"g"> g;
constexpr parameter<"k"> k;
constexpr input<"F", units::si::newton> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct C : offset<C, O, s * N::y> {};
struct P : offset<P, C, l * A::x> {};
struct Cart : particle<Cart, C, 2 * m> {};
struct Bob : particle<Bob, P, m> {};
struct System
    : kane_system<inertial<N>, coordinates<s, q>, speeds<v, u>, kinematics<dot(s) == v, dot(q) == u>,
                  bodies<Cart, Bob>, loads<gravity<g * N::x>, force<C, (F - k * s) * N::y>>> {};

} // namespace pendulum_on_cart
