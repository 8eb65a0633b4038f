#pragma once

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// The KUKA LBR iiwa 14 described by its joints, with a motor at each. The numbers are those of `iiwa.hpp`,
/// and the mass matrix and forces are identical to the last bit.
namespace iiwa_by_joints {

using namespace kanexpr;

using over = home<-1, 0, 0, 0, 0, 1, 0, 1, 0>;  // the axis along y of the previous link
using under = home<1, 0, 0, 0, 0, -1, 0, 1, 0>; // and in the opposite direction
template <class Self, class Parent, auto place, class Home, auto m, auto x, auto y, auto z, auto... scalars>
using link = pin<Self, Parent, axis<own::z>, at<place>, Home,
                 body<m, double(x) * own::x + double(y) * own::y + z * own::z, inertia<own, scalars...>>>;

struct Ground : inertial_ground<Ground> {};
struct Link1 : pin<Link1, Ground, axis<own::z>, at<0.1575 * Ground::z>,
                   body<4, -0.03 * own::y + 0.12 * own::z, inertia<own, 0.1, 0.09000000000000001, 0.02>>> {};
struct Link2 : link<Link2, Link1, 0.2025 * Link1::z, over, 4, 0.0003, 0.059, 0.042, 0.050019999999999995,
                    0.01794364, 0.04397564, 7.079999999999999e-05, 0.009912, 5.04e-05> {};
struct Link3 : link<Link3, Link2, 0.2045 * Link2::y, over, 3, 0, 0.03, 0.13, 0.07999999999999999,
                    0.07500000000000001, 0.01> {};
struct Link4 : link<Link4, Link3, 0.2155 * Link3::z, under, 2.7, 0, 0.067, 0.034, 0.029958499999999992,
                    0.0099788, 0.028979699999999997, 0, 5.060000000000047e-05> {};
struct Link5 : link<Link5, Link4, 0.1845 * Link4::y, over, 1.7, 0.0001, 0.021, 0.07599999999999998,
                    0.020031100000000003, 0.018080783000000003, 0.005050282999999999, 3.5700000000000005e-06,
                    1.319999999999967e-05, 1.2919999999999998e-05> {};
using light = effective_inertia<inertia<own, 0.000499064, 0.0035997119999999997, 0.004699352, 0, 4.32e-07>>;
struct Link6 : pin<Link6, Link5, axis<own::z>, at<0.2155 * Link5::z>, under,
                   body<1.8, 0.0006 * own::y + 0.0004 * own::z, light>> {};
struct Link7 : link<Link7, Link6, 0.081 * Link6::y, over, 0.3, 0, 0, 0.02, 0.00088, 0.00088, 0.001> {};
struct System : kane_system<inertial<Ground>, joints<Link1, Link2, Link3, Link4, Link5, Link6, Link7>,
                            loads<gravity<-9.81 * Ground::z>, motor<Link1>, motor<Link2>, motor<Link3>,
                                  motor<Link4>, motor<Link5>, motor<Link6>, motor<Link7>>> {};

} // namespace iiwa_by_joints
