#pragma once

#include <kanexpr/kanexpr.hpp>

/// A body of any shape on a spherical joint, with a torque on it. A unit quaternion describes its
/// orientation; the speeds are the components of its angular velocity in its own axes.
namespace pivot_body {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"e0"> e0;
constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"Ixx", kilogram * pow<2>(meter)> Ixx;
constexpr parameter<"Iyy", kilogram * pow<2>(meter)> Iyy;
constexpr parameter<"Izz", kilogram * pow<2>(meter)> Izz;
constexpr parameter<"Ixy", kilogram * pow<2>(meter)> Ixy;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"a", meter> a; // from the joint to the mass center
constexpr parameter<"b", meter> b;
constexpr parameter<"c", meter> c;
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;
constexpr input<"T3", newton * meter> T3;

struct N : inertial_frame<N> {}; // z points up
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};

struct O : origin<O, N> {};
struct G : offset<G, O, a * B::x + b * B::y + c * B::z> {};

struct Body : rigid_body<Body, G, B, m, inertia<B, Ixx, Iyy, Izz, Ixy>> {};

struct System : kane_system<inertial<N>, coordinates<e0, e1, e2, e3>, speeds<u1, u2, u3>,
                            kinematics<kinematics_of<B, N>>, inputs<T1, T2, T3>, bodies<Body>,
                            loads<gravity<-g * N::z>, torque<B, T1 * B::x + T2 * B::y + T3 * B::z>>> {};

} // namespace pivot_body
