#pragma once

#include <kanexpr/kanexpr.hpp>

/// A solid torus that rolls on a plane without slipping: a disc with a round rim. The speeds are the
/// components of its angular velocity in the lean frame.
namespace rolling_torus {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"R", meter> R; // from the center to the middle of the tube
constexpr parameter<"a", meter> a; // radius of the tube
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct B : rotated<B, L, q3, L::y>,    // spin
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct C : origin<C, N> {};                                   // contact: no velocity in N
struct G : offset<G, C, a * N::z + R * L::z>, fixed_in<B> {}; // mass center

constexpr auto along_axis = m * (R * R + 3 * a * a / 4);
constexpr auto across_axis = m * (R * R / 2 + 5 * a * a / 8);

struct Torus : rigid_body<Torus, G, B, m, inertia<L, across_axis, along_axis, across_axis>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u3 / cos(q2), dot(q2) == u1, dot(q3) == u2 - u3 * tan(q2)>,
                            bodies<Torus>, loads<gravity<-g * N::z>>> {};

/// The same torus, with the position of its center among the coordinates and rolling as a constraint.
namespace by_rates {

constexpr coordinate<"q4", meter> q4;
constexpr coordinate<"q5", meter> q5;

struct B : rotated<B, L, q3, L::y> {};

struct O : origin<O, N> {}; // the position on the ground
struct G : offset<G, O, q4 * N::x + q5 * N::y + (a + R * cos(q2)) * N::z> {};
struct Contact : offset<Contact, G, -a * N::z - R * L::z>, fixed_in<B> {};

struct Torus : rigid_body<Torus, G, B, m, inertia<L, across_axis, along_axis, across_axis>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3, by_rates::q4, by_rates::q5>,
                      velocity_constraints<zero_along<velocity_of<by_rates::Contact>, N::x, N::y>>,
                      dependent<dot(by_rates::q4), dot(by_rates::q5)>, bodies<by_rates::Torus>,
                      loads<gravity<-g * N::z>>> {};

} // namespace rolling_torus
