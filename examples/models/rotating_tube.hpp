#pragma once

#include <kanexpr/kanexpr.hpp>

/// A bead on a spring in a smooth tube that rotates in a vertical plane by a prescribed angle.
namespace rotating_tube {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q", meter> q; // along the tube
constexpr speed<"u"> u;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"k", newton / meter> k;
constexpr parameter<"q0", meter> q0; // unstretched length of the spring
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * second / meter> c;
constexpr prescribed<"theta", radian> theta; // angle of the tube, a known function of time

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, theta, N::z> {};

struct O : origin<O, N> {};
struct P : offset<P, O, q * A::x> {};

struct Bead : particle<Bead, P, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            inputs<theta, dot(theta), dot(dot(theta))>, bodies<Bead>,
                            loads<gravity<-g * N::y>, force<P, -(k*(q - q0) + c * u) * A::x>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q>, inputs<theta, dot(theta), dot(dot(theta))>, bodies<Bead>,
                      loads<gravity<-g * N::y>, force<P, -(k*(q - q0) + c * dot(q)) * A::x>>> {};

} // namespace rotating_tube
