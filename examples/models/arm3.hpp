#pragma once

#include <kanexpr/kanexpr.hpp>

/// A spatial arm with three links; all masses, mass centers, inertias and lengths are parameters.
namespace arm3 {

using namespace kanexpr;
using namespace kanexpr::units::si;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"cx", i, meter> cx; // from the joint to the mass center
template <int i>
constexpr parameter<"cy", i, meter> cy;
template <int i>
constexpr parameter<"cz", i, meter> cz;
template <int i>
constexpr parameter<"Ixx", i, kilogram * pow<2>(meter)> Ixx;
template <int i>
constexpr parameter<"Iyy", i, kilogram * pow<2>(meter)> Iyy;
template <int i>
constexpr parameter<"Izz", i, kilogram * pow<2>(meter)> Izz;
template <int i>
constexpr parameter<"Ixy", i, kilogram * pow<2>(meter)> Ixy;
template <int i>
constexpr parameter<"Iyz", i, kilogram * pow<2>(meter)> Iyz;
template <int i>
constexpr parameter<"Izx", i, kilogram * pow<2>(meter)> Izx;
template <int i>
constexpr parameter<"lx", i, meter> lx; // from the joint to the next one
template <int i>
constexpr parameter<"ly", i, meter> ly;
template <int i>
constexpr parameter<"lz", i, meter> lz;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct B1 : rotated<B1, N, q<1>, N::z> {};
struct B2 : rotated<B2, B1, q<2>, B1::y> {};
struct B3 : rotated<B3, B2, q<3>, B2::x> {};

struct J1 : origin<J1, N> {};
struct J2 : offset<J2, J1, lx<1> * B1::x + ly<1> * B1::y + lz<1> * B1::z> {};
struct J3 : offset<J3, J2, lx<2> * B2::x + ly<2> * B2::y + lz<2> * B2::z> {};

/// Link number i, which rotates with `B` about the joint `J`.
template <int i, class J, class B>
struct Center : offset<Center<i, J, B>, J, cx<i> * B::x + cy<i> * B::y + cz<i> * B::z> {};
template <int i, class J, class B>
struct Link : rigid_body<Link<i, J, B>, Center<i, J, B>, B, m<i>,
                         inertia<B, Ixx<i>, Iyy<i>, Izz<i>, Ixy<i>, Iyz<i>, Izx<i>>> {};

// Each motor acts on its link and, with the opposite torque, on the previous one.
constexpr auto motor1 = T<1> * N::z;
constexpr auto motor2 = T<2> * B1::y;
constexpr auto motor3 = T<3> * B2::x;

struct System
    : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>>, speeds<u<1>, u<2>, u<3>>,
                  kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>>,
                  parameters<g, m<1>, cx<1>, cy<1>, cz<1>, Ixx<1>, Iyy<1>, Izz<1>, Ixy<1>, Iyz<1>, Izx<1>,
                             lx<1>, ly<1>, lz<1>, m<2>, cx<2>, cy<2>, cz<2>, Ixx<2>, Iyy<2>, Izz<2>, Ixy<2>,
                             Iyz<2>, Izx<2>, lx<2>, ly<2>, lz<2>, m<3>, cx<3>, cy<3>, cz<3>, Ixx<3>, Iyy<3>,
                             Izz<3>, Ixy<3>, Iyz<3>, Izx<3>>,
                  inputs<T<1>, T<2>, T<3>>, bodies<Link<1, J1, B1>, Link<2, J2, B2>, Link<3, J3, B3>>,
                  loads<gravity<-g * N::z>, torque<B1, motor1>, torque<B2, motor2>, torque<B1, -motor2>,
                        torque<B3, motor3>, torque<B2, -motor3>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q<1>, q<2>, q<3>>,
                      parameters<g, m<1>, cx<1>, cy<1>, cz<1>, Ixx<1>, Iyy<1>, Izz<1>, Ixy<1>, Iyz<1>, Izx<1>,
                                 lx<1>, ly<1>, lz<1>, m<2>, cx<2>, cy<2>, cz<2>, Ixx<2>, Iyy<2>, Izz<2>,
                                 Ixy<2>, Iyz<2>, Izx<2>, lx<2>, ly<2>, lz<2>, m<3>, cx<3>, cy<3>, cz<3>,
                                 Ixx<3>, Iyy<3>, Izz<3>, Ixy<3>, Iyz<3>, Izx<3>>,
                      inputs<T<1>, T<2>, T<3>>, bodies<Link<1, J1, B1>, Link<2, J2, B2>, Link<3, J3, B3>>,
                      loads<gravity<-g * N::z>, torque<B1, motor1>, torque<B2, motor2>, torque<B1, -motor2>,
                            torque<B3, motor3>, torque<B2, -motor3>>> {};

} // namespace arm3
