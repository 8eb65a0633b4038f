#pragma once

#include <kanexpr/kanexpr.hpp>

/// Two bars in a vertical plane, with friction and a motor at each joint. The angle q2 is relative; the
/// speeds are the absolute angular speeds of the bars.
namespace double_pendulum {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m1", kilogram> m1;
constexpr parameter<"m2", kilogram> m2;
constexpr parameter<"d1", meter> d1; // from a bar's joint to its mass center
constexpr parameter<"d2", meter> d2;
constexpr parameter<"l1", meter> l1;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c1", newton * meter * second / radian> c1;
constexpr parameter<"c2", newton * meter * second / radian> c2;
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z>, angular_velocity<N, u1 * N::z> {};
struct B : rotated<B, A, q2, A::z>, angular_velocity<N, u2 * N::z> {};

struct O : origin<O, N> {}; // shoulder
struct G1 : offset<G1, O, d1 * A::x> {};
struct J : offset<J, O, l1 * A::x> {}; // elbow
struct G2 : offset<G2, J, d2 * B::x> {};

struct Bar1 : rigid_body<Bar1, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Bar2 : rigid_body<Bar2, G2, B, m2, inertia<B, 0, 0, I2>> {};

constexpr auto at_shoulder = (T1 - c1 * u1) * N::z;
constexpr auto at_elbow = (T2 - c2 * (u2 - u1)) * N::z;

struct System
    : kane_system<
          inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<dot(q1) == u1, dot(q2) == u2 - u1>,
          parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>, bodies<Bar1, Bar2>,
          loads<gravity<-g * N::y>, torque<A, at_shoulder>, torque<A, -at_elbow>, torque<B, at_elbow>>> {};

/// The same bars, with the rates of the angles as speeds.
namespace by_rates {

struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};

struct G1 : offset<G1, O, d1 * A::x> {};
struct J : offset<J, O, l1 * A::x> {};
struct G2 : offset<G2, J, d2 * B::x> {};

struct Bar1 : rigid_body<Bar1, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Bar2 : rigid_body<Bar2, G2, B, m2, inertia<B, 0, 0, I2>> {};

constexpr auto at_shoulder = (T1 - c1 * dot(q1)) * N::z;
constexpr auto at_elbow = (T2 - c2 * dot(q2)) * N::z;

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<
          inertial<N>, coordinates<q1, q2>, parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>,
          bodies<by_rates::Bar1, by_rates::Bar2>,
          loads<gravity<-g * N::y>, torque<by_rates::A, by_rates::at_shoulder>,
                torque<by_rates::A, -by_rates::at_elbow>, torque<by_rates::B, by_rates::at_elbow>>> {};

} // namespace double_pendulum
