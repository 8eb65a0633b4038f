// Three equal cranks in a row on the ground, joined by two equal bars; all bars are 1 m and 1 kg (the double
// four-bar of IFToMM's library of benchmarks). Twice a turn all bars are in line.
#pragma once

#include <kanexpr/kanexpr.hpp>

#include <cmath>
#include <numbers>

namespace double_four_bar {

using namespace kanexpr;

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr coordinate<"b1"> b1;
constexpr coordinate<"b2"> b2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"w1"> w1;
constexpr speed<"w2"> w2;

struct N : inertial_frame<N> {}; // y points up
struct Crank1 : rotated<Crank1, N, q1, N::z> {};
struct Crank2 : rotated<Crank2, N, q2, N::z> {};
struct Crank3 : rotated<Crank3, N, q3, N::z> {};
struct Bar1 : rotated<Bar1, N, b1, N::z> {};
struct Bar2 : rotated<Bar2, N, b2, N::z> {};

struct O1 : origin<O1, N> {};
struct O2 : offset<O2, O1, N::x> {};
struct O3 : offset<O3, O2, N::x> {};
struct P1 : offset<P1, O1, Crank1::x> {};
struct P2 : offset<P2, O2, Crank2::x> {};
struct P3 : offset<P3, O3, Crank3::x> {};
struct Q1 : offset<Q1, P1, Bar1::x> {};
struct Q2 : offset<Q2, P2, Bar2::x> {};
struct GCrank1 : offset<GCrank1, O1, 0.5 * Crank1::x> {};
struct GCrank2 : offset<GCrank2, O2, 0.5 * Crank2::x> {};
struct GCrank3 : offset<GCrank3, O3, 0.5 * Crank3::x> {};
struct GBar1 : offset<GBar1, P1, 0.5 * Bar1::x> {};
struct GBar2 : offset<GBar2, P2, 0.5 * Bar2::x> {};

template <class Frame, class Center>
struct bar : rigid_body<bar<Frame, Center>, Center, Frame, 1, inertia<Frame, 0, 0, 1.0 / 12>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3, b1, b2>, speeds<u1, u2, u3, w1, w2>,
                  kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3, dot(b1) == w1, dot(b2) == w2>,
                  configuration_constraints<zero_along<position_of<Q1, P2>, N::x, N::y>,
                                            zero_along<position_of<Q2, P3>, N::x, N::y>>,
                  bodies<bar<Crank1, GCrank1>, bar<Crank2, GCrank2>, bar<Crank3, GCrank3>, bar<Bar1, GBar1>,
                         bar<Bar2, GBar2>>,
                  loads<gravity<-9.81 * N::y>>> {};

/// The initial state: upright, moving down.
template <class T = double>
state<System, T> upright() {
  state<System, T> x = state<System, T>::Zero();
  x[q1] = x[q2] = x[q3] = std::numbers::pi_v<T> / 2;
  x[u1] = x[u2] = x[u3] = -1;
  return x;
}

/// The energy while the angles of the cranks are equal: the cranks rotate, and the bars translate.
inline double energy(double q, double u) {
  return 0.5 * u * u * (3.0 / 3 + 2) + 9.81 * std::sin(q) * (3 * 0.5 + 2);
}

} // namespace double_four_bar
