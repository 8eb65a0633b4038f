#pragma once

#include <kanexpr/kanexpr.hpp>

/// A sleigh on ice: its blade at P runs along A::x and does not slip sideways. A force acts on the blade
/// along its direction, and a torque steers.
namespace chaplygin_sleigh {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", meter> q1;
constexpr coordinate<"q2", meter> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"a", meter> a; // from the blade to the mass center
constexpr input<"F", newton> F;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q3, N::z> {};

constexpr auto v = u1 * A::x + u2 * A::y; // of the blade

struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y>, velocity<N, v> {};
struct G : offset<G, P, a * A::x> {};

struct Sleigh : rigid_body<Sleigh, G, A, m, inertia<A, 0, 0, I>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u3, u2>,
                            kinematics<dot(q1) == dot(v, N::x), dot(q2) == dot(v, N::y), dot(q3) == u3>,
                            velocity_constraints<u2 == 0>, dependent<u2>, inputs<F, T>, bodies<Sleigh>,
                            loads<force<P, F * A::x>, torque<A, T * N::z>>> {};

/// The same sleigh, with the rates of the coordinates as speeds.
namespace by_rates {

struct P : offset<P, O, q1 * N::x + q2 * N::y> {};
struct G : offset<G, P, a * A::x> {};

struct Sleigh : rigid_body<Sleigh, G, A, m, inertia<A, 0, 0, I>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3>,
                      velocity_constraints<zero_along<velocity_of<by_rates::P>, A::y>>, inputs<F, T>,
                      bodies<by_rates::Sleigh>, loads<force<by_rates::P, F * A::x>, torque<A, T * N::z>>> {};

} // namespace chaplygin_sleigh
