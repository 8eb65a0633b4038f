#pragma once

#include <kanexpr/beams.hpp>
#include <kanexpr/kanexpr.hpp>

/// A beam on a hub, with a rigid body at its end.
namespace slewing_arm {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr input<"T"> T;
constexpr parameter<"L"> L;
constexpr parameter<"rho"> rho;
constexpr parameter<"EI"> EI;
constexpr parameter<"m"> m;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Hub : rotated<Hub, N, q, N::z> {};
struct Root : offset<Root, O, 0.1 * Hub::x> {};
struct Arm : beam<Arm, Root, Hub::x, L, rho, bending<Hub::y, EI, clamped_free<2>>> {};
struct Tip : section<Tip, Arm, 1> {};
struct Center : offset<Center, Tip, 0.2 * Tip::x> {};
struct Load : rigid_body<Load, Center, Tip, m, inertia<Tip, 0, 0, 0.03 * m>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            bodies<Arm, Load>, loads<torque<Hub, T * N::z>, gravity<-9.81 * N::y>>> {};

} // namespace slewing_arm
