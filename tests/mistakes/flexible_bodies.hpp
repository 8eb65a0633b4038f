#pragma once

#include <kanexpr/flexible.hpp>
#include <kanexpr/kanexpr.hpp>

// The common part of the programs about flexible bodies that are given by numbers.

using namespace kanexpr;

constexpr flexible_body_data<1, 1> bar{.mass = 3,
                                       .inertia = {0, 4, 4},
                                       .modal_mass = {1},
                                       .stiffness = {50},
                                       .nodes = {{.called = "12", .position = {2}}}};
constexpr flexible_body_data<1, 0> without_mass{.modal_mass = {1}};
constexpr double number = 3;

constexpr coordinate<"q"> q;
constexpr coordinate<"p"> p;
constexpr speed<"u"> u;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Bar : flexible_body<Bar, O, N, bar> {}; // a valid body

template <class... Words>
using system_of = kane_system<inertial<N>, Words...>;

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  const auto udot = eom::udot(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(udot);
}
