#pragma once

#include <kanexpr/kanexpr.hpp>

#include <utility>

/// An arm with six links whose lengths and inertial parameters are all symbols, 76 in total. The first link
/// rotates about the vertical, the others about the axes of their joints, with a wrist at the end.
namespace arm6 {

using namespace kanexpr;
using namespace kanexpr::units::si;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;
constexpr parameter<"g", meter / pow<2>(second)> g;

template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"x", i, meter> x; // of the mass center, in the link's axes
template <int i>
constexpr parameter<"y", i, meter> y;
template <int i>
constexpr parameter<"z", i, meter> z;
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
constexpr parameter<"a", i, meter> a; // of the next joint, in the link's axes
template <int i>
constexpr parameter<"b", i, meter> b;
template <int i>
constexpr parameter<"d", i, meter> d;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};

template <int i>
struct Link;
template <>
struct Link<1> : rotated<Link<1>, N, q<1>, N::z> {};
template <>
struct Link<2> : rotated<Link<2>, Link<1>, q<2>, Link<1>::y> {};
template <>
struct Link<3> : rotated<Link<3>, Link<2>, q<3>, Link<2>::y> {};
template <>
struct Link<4> : rotated<Link<4>, Link<3>, q<4>, Link<3>::x> {};
template <>
struct Link<5> : rotated<Link<5>, Link<4>, q<5>, Link<4>::y> {};
template <>
struct Link<6> : rotated<Link<6>, Link<5>, q<6>, Link<5>::x> {};

/// Joint i, about which link i rotates.
template <int i>
struct Joint : offset<Joint<i>, Joint<i - 1>,
                      a<i - 1> * Link<i - 1>::x + b<i - 1> * Link<i - 1>::y + d<i - 1> * Link<i - 1>::z> {};
template <>
struct Joint<1> : offset<Joint<1>, O, 0.0 * N::x> {};

template <int i>
struct Center : offset<Center<i>, Joint<i>, x<i> * Link<i>::x + y<i> * Link<i>::y + z<i> * Link<i>::z> {};
template <int i>
struct Body : rigid_body<Body<i>, Center<i>, Link<i>, m<i>,
                         inertia<Link<i>, Ixx<i>, Iyy<i>, Izz<i>, Ixy<i>, Iyz<i>, Izx<i>>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>>,
                            bodies<Body<1>, Body<2>, Body<3>, Body<4>, Body<5>, Body<6>>,
                            loads<gravity<-g * N::z>, torque<Link<1>, T<1> * N::z>,
                                  torque<Link<2>, T<2> * Link<1>::y>, torque<Link<1>, -T<2> * Link<1>::y>,
                                  torque<Link<3>, T<3> * Link<2>::y>, torque<Link<2>, -T<3> * Link<2>::y>,
                                  torque<Link<4>, T<4> * Link<3>::x>, torque<Link<3>, -T<4> * Link<3>::x>,
                                  torque<Link<5>, T<5> * Link<4>::y>, torque<Link<4>, -T<5> * Link<4>::y>,
                                  torque<Link<6>, T<6> * Link<5>::x>, torque<Link<5>, -T<6> * Link<5>::x>>> {
};

} // namespace arm6
