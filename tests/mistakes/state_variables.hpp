#pragma once

#include <kanexpr/kanexpr.hpp>

// The common part of the programs about state variables.

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr state_variable<"z"> z;
constexpr state_variable<"y"> y;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct B : particle<B, P, m> {};

template <class... Words>
using system_of = kane_system<inertial<N>, coordinates<q>, speeds<u>, bodies<B>, Words...>;
template <class... Words>
using moved = system_of<kinematics<dot(q) == u>, Words...>;

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  const auto udot = eom::udot(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(udot);
}
