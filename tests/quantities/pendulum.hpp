// The pendulum of docs/guide/quantities.md, whose symbols state their units.
#pragma once

#include <kanexpr/kanexpr.hpp>

namespace pendulum_with_units {

using namespace kanexpr;
namespace si = kanexpr::units::si;

#include <docs/guide/quantities/model.cpp>

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<g * N::x>, torque<A, (T - c * u) * N::z>>> {};
using eom = equations_of_motion<System>;

} // namespace pendulum_with_units
