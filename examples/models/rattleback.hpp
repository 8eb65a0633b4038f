#pragma once

#include <kanexpr/kanexpr.hpp>

/// A rattleback: half an ellipsoid that rolls on a plane, with principal axes of inertia that are rotated
/// relative to the axes of its surface. Kane & Levinson (1982), Realistic mathematical modeling of the
/// rattleback.
namespace rattleback {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1; // yaw
constexpr coordinate<"q2", radian> q2; // roll
constexpr coordinate<"q3", radian> q3; // pitch
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"a", meter> a; // semi-axes of the ellipsoid
constexpr parameter<"b", meter> b;
constexpr parameter<"c", meter> c;
constexpr parameter<"h", meter> h; // from its center down to the mass center
constexpr parameter<"m", kilogram> m;
constexpr parameter<"Ixx", kilogram * pow<2>(meter)> Ixx;
constexpr parameter<"Iyy", kilogram * pow<2>(meter)> Iyy;
constexpr parameter<"Izz", kilogram * pow<2>(meter)> Izz;
constexpr parameter<"Ixy", kilogram * pow<2>(meter)> Ixy;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"sigma", newton * meter * second / radian>
    sigma; // friction: torque over angular velocity

struct N : inertial_frame<N> {}; // z points up
struct B : body_fixed<B, N, "zxy", q1, q2, q3>,
           angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};

// The lowest point of the ellipsoid, from its center.
constexpr auto stretched =
    a * a * dot(N::z, B::x) * B::x + b * b * dot(N::z, B::y) * B::y + c * c * dot(N::z, B::z) * B::z;
constexpr auto lowest = -stretched / sqrt(dot(stretched, N::z));

constexpr auto friction = -sigma * (u1 * B::x + u2 * B::y + u3 * B::z);

struct P : origin<P, N> {}; // contact: no velocity in N
struct G : offset<G, P, -lowest - h * B::z>, fixed_in<B> {};

struct Stone : rigid_body<Stone, G, B, m, inertia<B, Ixx, Iyy, Izz, Ixy>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>, kinematics<kinematics_of<B, N>>,
                  bodies<Stone>, loads<gravity<-g * N::z>, torque<B, friction>>> {};

} // namespace rattleback
