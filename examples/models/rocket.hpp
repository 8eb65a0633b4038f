#pragma once

#include <kanexpr/kanexpr.hpp>

/// A rocket that climbs straight up while its mass burns away. Forces are rates of momentum, d(m v)/dt, so T
/// includes the momentum that the gas carries away: T is the thrust plus dot(m)*u.
namespace rocket {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q", meter> q;
constexpr speed<"u"> u;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"cd", kilogram / meter> cd; // drag divided by the square of the speed
constexpr prescribed<"m", kilogram> m;          // mass, a known function of time
constexpr input<"T", newton> T;

struct N : inertial_frame<N> {}; // z points up

struct O : origin<O, N> {};
struct P : offset<P, O, q * N::z> {};

struct Rocket : particle<Rocket, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, inputs<m, dot(m), T>,
                  bodies<Rocket>, loads<force<P, (T - m * g - cd * u * u) * N::z>>> {};

struct LagrangeSystem : lagrange_system<inertial<N>, coordinates<q>, inputs<m, dot(m), T>, bodies<Rocket>,
                                        loads<force<P, (T - m * g - cd * dot(q) * dot(q)) * N::z>>> {};

} // namespace rocket
