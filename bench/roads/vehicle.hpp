#pragma once

#include <kanexpr/kanexpr.hpp>

/// A car as one track: both wheels roll without slipping sideways, a force drives the rear one and a torque
/// turns the fork of the front one against the frame.
namespace vehicle {

using namespace kanexpr;

constexpr coordinate<"q1"> q1; // of the rear wheel's contact
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3; // heading
constexpr coordinate<"q4"> q4; // steering
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr parameter<"m"> m;
constexpr parameter<"I"> inertia_of_frame;
constexpr parameter<"J"> inertia_of_fork;
constexpr parameter<"a"> a; // from the rear wheel to the mass centre
constexpr parameter<"l"> l; // to the front wheel
constexpr input<"F"> F;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q3, N::z> {};
struct S : rotated<S, A, q4, A::z> {};

constexpr auto v = u1 * A::x + u2 * A::y;

struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y>, velocity<N, v> {};
struct G : offset<G, P, a * A::x> {};
struct Q : offset<Q, P, l * A::x> {};

struct Frame : rigid_body<Frame, G, A, m, inertia<A, 0, 0, inertia_of_frame>> {};
struct Fork : rigid_body<Fork, Q, S, 20, inertia<S, 0, 0, inertia_of_fork>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3, q4>, speeds<u1, u2, u3, u4>,
                  kinematics<dot(q1) == dot(v, N::x), dot(q2) == dot(v, N::y), dot(q3) == u3, dot(q4) == u4>,
                  velocity_constraints<u2 == 0, zero_along<velocity_of<Q>, S::y>>, dependent<u2, u3>,
                  parameters<m, inertia_of_frame, inertia_of_fork, a, l>, inputs<F, T>, bodies<Frame, Fork>,
                  loads<force<P, F * A::x>, torque<S, T * N::z>, torque<A, -T * N::z>>> {};

} // namespace vehicle
