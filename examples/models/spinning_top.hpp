#pragma once

#include <kanexpr/kanexpr.hpp>

/// A symmetric top whose tip is fixed. The speeds are the components of its angular velocity in the frame
/// that precesses and nutates with the top but does not spin.
namespace spinning_top {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia about a transverse axis
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about the spin axis

struct N : inertial_frame<N> {};
struct F1 : rotated<F1, N, q1, N::z> {};   // precession
struct F2 : rotated<F2, F1, q2, F1::x> {}; // nutation
struct B : rotated<B, F2, q3, F2::z>,      // spin
           angular_velocity<N, u1 * F2::x + u2 * F2::y + u3 * F2::z> {};

struct O : origin<O, N> {};                         // tip
struct G : offset<G, O, l * F2::z>, fixed_in<B> {}; // mass center

struct Top : rigid_body<Top, G, B, m, inertia<F2, A, A, C>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                  kinematics<u1 == dot(q2), u2 == dot(q1) * sin(q2), u3 == dot(q3) + dot(q1) * cos(q2)>,
                  parameters<m, l, g, A, C>, bodies<Top>, loads<gravity<-g * N::z>>> {};

/// The same top, with the rates of the angles as speeds.
namespace by_rates {

struct B : rotated<B, F2, q3, F2::z> {};

struct G : offset<G, O, l * F2::z> {};

struct Top : rigid_body<Top, G, B, m, inertia<F2, A, A, C>> {};

} // namespace by_rates

struct LagrangeSystem : lagrange_system<inertial<N>, coordinates<q1, q2, q3>, parameters<m, l, g, A, C>,
                                        bodies<by_rates::Top>, loads<gravity<-g * N::z>>> {};

} // namespace spinning_top
