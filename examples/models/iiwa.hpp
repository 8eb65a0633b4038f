#pragma once

#include <kanexpr/kanexpr.hpp>

/// The KUKA LBR iiwa 14: seven revolute joints, with numeric values bound in the type. The published inertia
/// of its sixth link is not that of any rigid body.
namespace iiwa {

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
struct Link1_joint : offset<Link1_joint, O, 0.1575 * N::z> {};
struct Link1_center : offset<Link1_center, Link1_joint, -0.03 * Link1::y + 0.12 * Link1::z> {};
struct Link1_body
    : rigid_body<Link1_body, Link1_center, Link1, 4, inertia<Link1, 0.1, 0.09000000000000001, 0.02>> {};

struct Link2_home : direction_cosines<Link2_home, Link1, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link2 : rotated<Link2, Link2_home, q<2>, Link2_home::z> {};
struct Link2_joint : offset<Link2_joint, Link1_joint, 0.2025 * Link1::z> {};
struct Link2_center
    : offset<Link2_center, Link2_joint, 0.0003 * Link2::x + 0.059 * Link2::y + 0.042 * Link2::z> {};
struct Link2_body : rigid_body<Link2_body, Link2_center, Link2, 4,
                               inertia<Link2, 0.050019999999999995, 0.01794364, 0.04397564,
                                       7.079999999999999e-05, 0.009912, 5.04e-05>> {};

struct Link3_home : direction_cosines<Link3_home, Link2, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link3 : rotated<Link3, Link3_home, q<3>, Link3_home::z> {};
struct Link3_joint : offset<Link3_joint, Link2_joint, 0.2045 * Link2::y> {};
struct Link3_center : offset<Link3_center, Link3_joint, 0.03 * Link3::y + 0.13 * Link3::z> {};
struct Link3_body : rigid_body<Link3_body, Link3_center, Link3, 3,
                               inertia<Link3, 0.07999999999999999, 0.07500000000000001, 0.01>> {};

struct Link4_home : direction_cosines<Link4_home, Link3, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link4 : rotated<Link4, Link4_home, q<4>, Link4_home::z> {};
struct Link4_joint : offset<Link4_joint, Link3_joint, 0.2155 * Link3::z> {};
struct Link4_center : offset<Link4_center, Link4_joint, 0.067 * Link4::y + 0.034 * Link4::z> {};
struct Link4_body
    : rigid_body<
          Link4_body, Link4_center, Link4, 2.7,
          inertia<Link4, 0.029958499999999992, 0.0099788, 0.028979699999999997, 0, 5.060000000000047e-05>> {};

struct Link5_home : direction_cosines<Link5_home, Link4, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link5 : rotated<Link5, Link5_home, q<5>, Link5_home::z> {};
struct Link5_joint : offset<Link5_joint, Link4_joint, 0.1845 * Link4::y> {};
struct Link5_center : offset<Link5_center, Link5_joint,
                             0.0001 * Link5::x + 0.021 * Link5::y + 0.07599999999999998 * Link5::z> {};
struct Link5_body
    : rigid_body<Link5_body, Link5_center, Link5, 1.7,
                 inertia<Link5, 0.020031100000000003, 0.018080783000000003, 0.005050282999999999,
                         3.5700000000000005e-06, 1.319999999999967e-05, 1.2919999999999998e-05>> {};

struct Link6_home : direction_cosines<Link6_home, Link5, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link6 : rotated<Link6, Link6_home, q<6>, Link6_home::z> {};
struct Link6_joint : offset<Link6_joint, Link5_joint, 0.2155 * Link5::z> {};
struct Link6_center : offset<Link6_center, Link6_joint, 0.0006 * Link6::y + 0.0004 * Link6::z> {};
struct Link6_body
    : rigid_body<
          Link6_body, Link6_center, Link6, 1.8,
          effective_inertia<inertia<Link6, 0.000499064, 0.0035997119999999997, 0.004699352, 0, 4.32e-07>>> {};

struct Link7_home : direction_cosines<Link7_home, Link6, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link7 : rotated<Link7, Link7_home, q<7>, Link7_home::z> {};
struct Link7_joint : offset<Link7_joint, Link6_joint, 0.081 * Link6::y> {};
struct Link7_center : offset<Link7_center, Link7_joint, 0.02 * Link7::z> {};
struct Link7_body
    : rigid_body<Link7_body, Link7_center, Link7, 0.3, inertia<Link7, 0.00088, 0.00088, 0.001>> {};

struct System
    : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>, q<7>>,
                  speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>, u<7>>,
                  kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>, dot(q<4>) == u<4>,
                             dot(q<5>) == u<5>, dot(q<6>) == u<6>, dot(q<7>) == u<7>>,
                  inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>, T<7>>,
                  bodies<Link1_body, Link2_body, Link3_body, Link4_body, Link5_body, Link6_body, Link7_body>,
                  loads<gravity<-9.81 * N::z>, torque<Link1, T<1> * Link1::z>, torque<Link2, T<2> * Link2::z>,
                        torque<Link1, -T<2> * Link2::z>, torque<Link3, T<3> * Link3::z>,
                        torque<Link2, -T<3> * Link3::z>, torque<Link4, T<4> * Link4::z>,
                        torque<Link3, -T<4> * Link4::z>, torque<Link5, T<5> * Link5::z>,
                        torque<Link4, -T<5> * Link5::z>, torque<Link6, T<6> * Link6::z>,
                        torque<Link5, -T<6> * Link6::z>, torque<Link7, T<7> * Link7::z>,
                        torque<Link6, -T<7> * Link7::z>>> {};

} // namespace iiwa
