#pragma once

#include <kanexpr/kanexpr.hpp>

/// Two beads with numbers as masses, so that u̇ always exists. Each parameter determines one entry of A or B:
/// the first or the last that is not a number.
namespace sliders {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
constexpr parameter<"a"> a;
constexpr parameter<"b"> b;
constexpr parameter<"c"> c;
constexpr parameter<"d"> d;
constexpr input<"F"> F;
constexpr input<"G"> G;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x> {};
struct Q : offset<Q, O, y * N::y> {};
struct First : particle<First, P, 1> {};
struct Second : particle<Second, Q, 1> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<u, v>, kinematics<dot(x) == u, dot(y) == v>,
                  parameters<a, b, c, d>, inputs<F, G>, bodies<First, Second>,
                  loads<force<P, (a * a * x + c * c * F) * N::x>, force<Q, (b * b * v + d * d * G) * N::y>>> {
};

} // namespace sliders
