#pragma once

#include <kanexpr/kanexpr.hpp>

/// A pendulum on a nonlinear spring; its loads call functions that <complex> does not have.
namespace curved {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"k"> k;
constexpr parameter<"v"> v;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<m, l, k, v>, inputs<T>, bodies<Bob>,
                            loads<torque<A, -k * cbrt(q - 1) * N::z>, torque<A, -erf(u / v) * N::z>,
                                  torque<A, wrap_to_pi(3 * q - T) * N::z>,
                                  torque<A, (atan2(T, q) + sign(u) * abs(q)) * N::z>>> {};

} // namespace curved
