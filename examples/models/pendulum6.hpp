#pragma once

#include <kanexpr/kanexpr.hpp>

/// Six uniform rods of 1 m and 1 kg, hinged end to end in a vertical plane; each angle is measured from the
/// previous rod.
namespace pendulum6 {

using namespace kanexpr;
using namespace kanexpr::units::si;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;

constexpr int length = 1, mass = 1;

struct N : inertial_frame<N> {}; // y points up

template <int i>
struct Rod : rotated<Rod<i>, Rod<i - 1>, q<i>, N::z> {};
template <>
struct Rod<1> : rotated<Rod<1>, N, q<1>, N::z> {};

template <int i>
struct Hinge : offset<Hinge<i>, Hinge<i - 1>, length * Rod<i - 1>::x> {};
template <>
struct Hinge<1> : origin<Hinge<1>, N> {};

template <int i>
struct Middle : offset<Middle<i>, Hinge<i>, length * Rod<i>::x / 2> {};

template <int i>
struct Body : rigid_body<Body<i>, Middle<i>, Rod<i>, mass,
                         inertia<Rod<i>, 0, rational<1, 12> * mass * length * length,
                                 rational<1, 12> * mass * length * length>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            bodies<Body<1>, Body<2>, Body<3>, Body<4>, Body<5>, Body<6>>,
                            loads<gravity<-9.81 * N::y>>> {};

} // namespace pendulum6
