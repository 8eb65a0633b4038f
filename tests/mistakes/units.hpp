#pragma once

#include <kanexpr/kanexpr.hpp>

// The common part of the programs about units.

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"k", newton / meter> k;
constexpr input<"F", newton> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};

template <class... Loads>
using pendulum = kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                             loads<Loads...>>;

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  const auto udot = eom::udot(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(udot);
}
