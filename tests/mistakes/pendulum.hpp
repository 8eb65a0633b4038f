#pragma once

#include <kanexpr/kanexpr.hpp>

// A valid pendulum, parts of which the programs here reuse, and the typical uses of a system.

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"g"> g;
constexpr input<"T"> T;
constexpr time_variable t;

constexpr coordinate<"s"> s; // for a second degree of freedom
constexpr speed<"v"> v;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};

using weight = force<P, -m * g * N::y>;

template <class... Bodies>
using pendulum_with =
    kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bodies...>>;

// With a block on the ground, and the constraint between the two.
struct S : offset<S, O, s * N::x> {};
struct Block : particle<Block, S, m> {};

template <class... Words>
using bound_pendulum = kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                                   kinematics<dot(q) == u, dot(s) == v>, bodies<Bob, Block>, Words...>;

// Both with Lagrange's method.
template <class... Words>
using rates_of_pendulum = lagrange_system<inertial<N>, coordinates<q>, Words...>;
template <class... Words>
using rates_of_both = lagrange_system<inertial<N>, coordinates<q, s>, Words...>;

template <class System>
void use_rates() {
  using eom = equations_of_motion<System>;
  typename eom::state x;
  x[q] = 0.1;
  x[dot(q)] = 0.2;
  const auto [M, rhs] =
      eom::together(eom::mass_matrix, eom::rhs)(x, typename eom::parameters(), typename eom::inputs());
  static_cast<void>(M), static_cast<void>(rhs);
}

template <class System>
void use() {
  using eom = equations_of_motion<System>;
  typename eom::state x;
  typename eom::parameters p;
  typename eom::inputs r;
  x[q] = 0.1;
  x[u] = 0.2;
  const auto M = eom::mass_matrix(x, p, r);
  const auto f = eom::forcing(x, p, r);
  const auto [M_again, rhs] = eom::together(eom::mass_matrix, eom::rhs)(x, p, r);
  static_cast<void>(M), static_cast<void>(f), static_cast<void>(M_again), static_cast<void>(rhs);
  static_assert(eom::cost(eom::forcing).multiplications < 100);
}
