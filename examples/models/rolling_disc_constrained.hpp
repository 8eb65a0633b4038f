#pragma once

#include <kanexpr/kanexpr.hpp>

/// The rolling disc again, now with the position of its center among the coordinates and rolling without
/// slipping as a constraint.
namespace rolling_disc_constrained {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr coordinate<"q4", meter> q4;
constexpr coordinate<"q5", meter> q5;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr parameter<"r", meter> r;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct R : rotated<R, L, q3, L::y>,    // spin
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct O : origin<O, N> {}; // the position on the ground
struct Dmc : offset<Dmc, O, q4 * N::x + q5 * N::y + r * cos(q2) * N::z> {};
struct Contact : offset<Contact, Dmc, -r * L::z>,
                 fixed_in<R> {}; // the point of the rim that touches the ground

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3, q4, q5>, speeds<u1, u2, u3, u4, u5>,
                            kinematics<kinematics_of<R, N>, dot(q4) == u4, dot(q5) == u5>,
                            velocity_constraints<zero_along<velocity_of<Contact>, N::x, N::y>>,
                            dependent<u4, u5>, bodies<Disc>, loads<gravity<-g * N::z>>> {};

/// The same disc, with the rates of the coordinates as speeds.
namespace by_rates {

struct R : rotated<R, L, q3, L::y> {};
struct Contact : offset<Contact, Dmc, -r * L::z>, fixed_in<R> {};

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3, q4, q5>,
                      velocity_constraints<zero_along<velocity_of<by_rates::Contact>, N::x, N::y>>,
                      dependent<dot(q4), dot(q5)>, bodies<by_rates::Disc>, loads<gravity<-g * N::z>>> {};

} // namespace rolling_disc_constrained
