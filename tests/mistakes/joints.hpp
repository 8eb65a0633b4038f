#pragma once

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

// The common part of the programs about joints.

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr input<"T"> T;

struct Ground : inertial_ground<Ground> {};
using mass = body<2, 0.3 * own::x, inertia<own, 1, 1, 1>>;
using up = axis<own::z>;

struct Arm : pin<Arm, Ground, up, mass> {}; // a valid joint

template <class... Words>
using jointed = kane_system<inertial<Ground>, Words...>;

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  const auto udot = eom::udot(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(udot);
}
