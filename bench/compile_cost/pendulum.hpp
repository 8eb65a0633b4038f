#pragma once

#include <kanexpr/describe.hpp>

/// The model of files/linked, which a library compiles once.
namespace pendulum {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"l"> l;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct A : rotated<A, N, q, N::z> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, 1> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<9.81 * N::x>>> {};

} // namespace pendulum
