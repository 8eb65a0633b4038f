#pragma once

#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

// The common part of the programs about beams.

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"L"> L;
constexpr parameter<"m"> m;
constexpr parameter<"EI"> EI;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
using bends = bending<N::y, EI, clamped_free<1>>;

struct Rod : beam<Rod, O, N::x, L, m, bends> {}; // a valid beam

template <class... Words>
using system_of = kane_system<inertial<N>, Words...>;

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  const auto udot = eom::udot(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(udot);
}
