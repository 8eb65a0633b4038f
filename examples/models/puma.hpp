#pragma once

#include <kanexpr/kanexpr.hpp>

/// The Puma 560 with all ten inertial parameters of each link; numeric values are bound in the type. Two
/// links have effective inertias: they include the contributions of motors and gears and are not those of any
/// rigid body.
namespace puma {

using namespace kanexpr;
using namespace kanexpr::units::si;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

struct Link1 : rotated<Link1, N, q<1>, N::z> {};
struct Link1_center : offset<Link1_center, O, 0.011 * Link1::x - 0.013 * Link1::y + 0.017 * Link1::z> {};
struct Link1_body : rigid_body<Link1_body, Link1_center, Link1, 13,
                               effective_inertia<inertia<Link1, 0.1, 0.1, 0.35, 0.011000000000000001,
                                                         0.005000000000000001, -0.007000000000000002>>> {};

struct Link2_home : direction_cosines<Link2_home, Link1, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link2 : rotated<Link2, Link2_home, q<2>, Link2_home::z> {};
struct Link2_center
    : offset<Link2_center, O, 0.0801 * Link2::x - 0.0083 * Link2::y + 0.002700000000000001 * Link2::z> {};
struct Link2_body
    : rigid_body<Link2_body, Link2_center, Link2, 17.4,
                 inertia<Link2, 0.13, 0.524, 0.539, 0.01573, 0.007150000000000001, -0.010010000000000002>> {};

struct Link3 : rotated<Link3, Link2, q<3>, Link2::z> {};
struct Link3_joint : offset<Link3_joint, O, 0.4318 * Link2::x + 0.15005 * Link2::z> {};
struct Link3_center
    : offset<Link3_center, Link3_joint,
             0.013199999999999998 * Link3::x - 0.08560000000000001 * Link3::y + 0.0344 * Link3::z> {};
struct Link3_body
    : rigid_body<Link3_body, Link3_center, Link3, 4.8,
                 effective_inertia<inertia<Link3, 0.066, 0.012500000000000004, 0.086, 0.0016500000000000004,
                                           0.0007500000000000024, -0.0010500000000000002>>> {};

struct Link4_home : direction_cosines<Link4_home, Link3, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link4 : rotated<Link4, Link4_home, q<4>, Link4_home::z> {};
struct Link4_joint : offset<Link4_joint, Link3_joint, 0.0203 * Link3::x + 0.4318 * Link3::y> {};
struct Link4_center : offset<Link4_center, Link4_joint,
                             0.0143 * Link4::x - 0.0169 * Link4::y + 0.003100000000000002 * Link4::z> {};
struct Link4_body : rigid_body<Link4_body, Link4_center, Link4, 0.82,
                               inertia<Link4, 0.0018000000000000002, 0.0018000000000000002, 0.0013,
                                       0.00018590000000000007, 8.45e-05, -0.0001183>> {};

struct Link5_home : direction_cosines<Link5_home, Link4, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link5 : rotated<Link5, Link5_home, q<5>, Link5_home::z> {};
struct Link5_center
    : offset<Link5_center, Link4_joint,
             0.015399999999999999 * Link5::x - 0.018199999999999997 * Link5::y + 0.0238 * Link5::z> {};
struct Link5_body
    : rigid_body<
          Link5_body, Link5_center, Link5, 0.34,
          inertia<Link5, 0.0003, 0.0003, 0.0004, 4.62e-05, 2.099999999999997e-05, -2.9399999999999956e-05>> {
};

struct Link6_home : direction_cosines<Link6_home, Link5, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link6 : rotated<Link6, Link6_home, q<6>, Link6_home::z> {};
struct Link6_center
    : offset<Link6_center, Link4_joint, 0.0165 * Link6::x - 0.0195 * Link6::y + 0.0575 * Link6::z> {};
struct Link6_body
    : rigid_body<Link6_body, Link6_center, Link6, 0.09,
                 inertia<Link6, 0.00014999999999999996, 0.00015000000000000001, 3.9999999999999996e-05,
                         6.600000000000001e-06, 3.000000000000005e-06, -4.199999999999994e-06>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>>,
                            bodies<Link1_body, Link2_body, Link3_body, Link4_body, Link5_body, Link6_body>,
                            loads<gravity<-9.81 * N::z>, torque<Link1, T<1> * Link1::z>,
                                  torque<Link2, T<2> * Link2::z>, torque<Link1, -T<2> * Link2::z>,
                                  torque<Link3, T<3> * Link3::z>, torque<Link2, -T<3> * Link3::z>,
                                  torque<Link4, T<4> * Link4::z>, torque<Link3, -T<4> * Link4::z>,
                                  torque<Link5, T<5> * Link5::z>, torque<Link4, -T<5> * Link5::z>,
                                  torque<Link6, T<6> * Link6::z>, torque<Link5, -T<6> * Link6::z>>> {};

} // namespace puma
