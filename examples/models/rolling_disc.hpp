#pragma once

#include <kanexpr/kanexpr.hpp>

/// A thin disc that rolls on a plane without slipping; the speeds are the components of its angular velocity
/// in the lean frame. Kane & Levinson (1985), section 3.8.
namespace rolling_disc {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"r", meter> r;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct R : rotated<R, L, q3, L::y>,    // spin, with the speeds chosen by hand
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct C : origin<C, N> {};            // contact: no velocity in N
struct Dmc : offset<Dmc, C, r * L::z>, // mass center, with the contact fixed in R
             fixed_in<R> {};

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u3 / cos(q2), dot(q2) == u1, dot(q3) == u2 - u3 * tan(q2)>,
                            bodies<Disc>, loads<force<Dmc, -m * g * Y::z>>> {};

} // namespace rolling_disc
