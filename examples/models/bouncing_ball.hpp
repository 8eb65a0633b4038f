#pragma once

#include <kanexpr/contact.hpp>
#include <kanexpr/kanexpr.hpp>

/// A ball that moves in a vertical plane, spins, and bounces on the ground.
namespace bouncing_ball {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"q", radian> q;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"w"> w;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"r", meter> r;
constexpr parameter<"k", newton / pow<3, 2>(meter)> k; // stiffness
constexpr parameter<"d", meter> d;                     // the distance over which the contact closes
constexpr parameter<"v", meter / second> v;            // the speed at which the restitution holds
constexpr parameter<"mu", dimensionless> mu;           // friction
constexpr parameter<"b", meter> b;                     // lever of the rolling resistance
constexpr parameter<"s", radian / second> s;           // angular velocity below which it is smoothed
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // x to the right, z up
struct B : rotated<B, N, q, N::y> {};
struct O : origin<O, N> {};
struct C : offset<C, O, x * N::x + z * N::z> {};

constexpr auto I = 0.4 * m * r * r;
struct Ball : rigid_body<Ball, C, B, m, inertia<B, I, I, I>> {};

using ground = contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<d>,
                       restitution<0.8, v>, coulomb_friction<mu>, rolling_resistance<b, s>>;

struct System
    : kane_system<inertial<N>, coordinates<x, z, q>, speeds<vx, vz, w>,
                  kinematics<dot(x) == vx, dot(z) == vz, dot(q) == w>, parameters<m, r, k, d, v, mu, b, s, g>,
                  bodies<Ball>, loads<gravity<-g * N::z>, ground>> {};

} // namespace bouncing_ball
