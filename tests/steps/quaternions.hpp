// Bodies whose orientation is described by quaternions.
#pragma once

#include <kanexpr/kanexpr.hpp>

namespace quaternions {

using namespace kanexpr;

constexpr coordinate<"e", 0> e0;
constexpr coordinate<"e", 1> e1;
constexpr coordinate<"e", 2> e2;
constexpr coordinate<"e", 3> e3;
constexpr coordinate<"f", 0> f0;
constexpr coordinate<"f", 1> f1;
constexpr coordinate<"f", 2> f2;
constexpr coordinate<"f", 3> f3;
constexpr speed<"u", 1> u1;
constexpr speed<"u", 2> u2;
constexpr speed<"u", 3> u3;
constexpr speed<"v", 1> v1;
constexpr speed<"v", 2> v2;
constexpr speed<"v", 3> v3;
constexpr parameter<"h"> h;

struct N : inertial_frame<N> {};
struct A : quaternion<A, N, e0, e1, e2, e3>, angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, 0.2 * A::x + 0.1 * A::z> {};
struct P : offset<P, O, 0.5 * A::x> {};
struct Upper : rigid_body<Upper, G, A, 2, inertia<A, 0.1, 0.2, 0.25, 0.01>> {};

// A double pendulum; the second kinematic equations are written by hand and not solved for the rates.
struct B : quaternion<B, N, f0, f1, f2, f3>, angular_velocity<N, v1 * own::x + v2 * own::y + v3 * own::z> {};
struct H : offset<H, P, 0.1 * B::x - 0.3 * B::z> {};
struct Lower : rigid_body<Lower, H, B, 1, inertia<B, 0.05, 0.06, 0.03>> {};
struct Two
    : kane_system<inertial<N>, coordinates<e0, f0, f1, f2, f3, e1, e2, e3>, speeds<u1, u2, u3, v1, v2, v3>,
                  kinematics<kinematics_of<A, N>,
                             v1 == 2 * (f0 * dot(f1) - f1 * dot(f0) - f2 * dot(f3) + f3 * dot(f2)),
                             v2 == 2 * (f0 * dot(f2) - f2 * dot(f0) - f3 * dot(f1) + f1 * dot(f3)),
                             v3 == 2 * (f0 * dot(f3) - f3 * dot(f0) - f1 * dot(f2) + f2 * dot(f1)),
                             f0 * dot(f0) + f1 * dot(f1) + f2 * dot(f2) + f3 * dot(f3) == 0>,
                  bodies<Upper, Lower>, loads<gravity<-9.81 * N::z>>> {};

// The end of a body slides at a constant height; this constraint is solved for an entry of its quaternion.
struct Sliding : kane_system<inertial<N>, coordinates<e0, e1, e2, e3>, speeds<u1, u2, u3>,
                             kinematics<kinematics_of<A, N>>,
                             configuration_constraints<dot(position_of<P, O>, N::z) == h>, dependent<e2, u2>,
                             bodies<Upper>, loads<gravity<-9.81 * N::y>>> {};

} // namespace quaternions
