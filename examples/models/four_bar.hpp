#pragma once

#include <kanexpr/kanexpr.hpp>

/// A crank, a coupler and a rocker in a vertical plane; the fourth bar is the ground. A motor drives the
/// crank. Each angle is measured from the previous bar.
namespace four_bar {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"l0", meter> l0;
constexpr parameter<"l1", meter> l1;
constexpr parameter<"l2", meter> l2;
constexpr parameter<"l3", meter> l3;
constexpr parameter<"d1", meter> d1; // from a bar's joint to its mass center
constexpr parameter<"d2", meter> d2;
constexpr parameter<"d3", meter> d3;
constexpr parameter<"m1", kilogram> m1;
constexpr parameter<"m2", kilogram> m2;
constexpr parameter<"m3", kilogram> m3;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"I3", kilogram * pow<2>(meter)> I3;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};
struct C : rotated<C, B, q3, B::z> {};

struct O : origin<O, N> {};
struct P1 : offset<P1, O, l1 * A::x> {};
struct P2 : offset<P2, P1, l2 * B::x> {};
struct P3 : offset<P3, P2, l3 * C::x> {};
struct Bearing : offset<Bearing, O, l0 * N::x> {}; // bearing of the rocker on the ground

struct G1 : offset<G1, O, d1 * A::x> {};
struct G2 : offset<G2, P1, d2 * B::x> {};
struct G3 : offset<G3, P2, d3 * C::x> {};

struct Crank : rigid_body<Crank, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Coupler : rigid_body<Coupler, G2, B, m2, inertia<B, 0, 0, I2>> {};
struct Rocker : rigid_body<Rocker, G3, C, m3, inertia<C, 0, 0, I3>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>,
                            configuration_constraints<zero_along<position_of<P3, Bearing>, N::x, N::y>>,
                            dependent<q2, q3, u2, u3>, inputs<T>, bodies<Crank, Coupler, Rocker>,
                            loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3>,
                      configuration_constraints<zero_along<position_of<P3, Bearing>, N::x, N::y>>,
                      dependent<q2, q3, dot(q2), dot(q3)>, inputs<T>, bodies<Crank, Coupler, Rocker>,
                      loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};

} // namespace four_bar
