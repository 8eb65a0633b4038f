// builds: clang++ sanitize all
#include "describe/joints/by_hand.hpp"

#include <Eigen/Geometry>

namespace {

using namespace by_hand;
using Eigen::Vector3d;

namespace pendulum {
struct Link : universal<Link, Ground, axis<Ground::y, own::x>, seat, home<0.7, Ground::z>, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct Home : rotated<Home, Ground, 0.7, Ground::z> {};
struct Cross : rotated<Cross, Home, q, Ground::y> {};
struct Child : rotated<Child, Cross, s, Cross::x> {};
struct Joint : offset<Joint, Ground, seat::in_parent> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q, s>, speeds<u, v>, kinematics<simple>, bodies<Body>,
                          loads<weight>> {};
} // namespace pendulum

TEST(universal, turns_about_two_axes) { expect_same_motion<pendulum::System, pendulum::Hand>(); }

// Two shafts at an angle β, connected by a cross (Uicker, Pennock & Shigley, Theory of Machines and
// Mechanisms, the universal joint): ω₂/ω₁ = cos β / (1 − sin² β cos² θ), where θ is the angle of the first
// arm of the cross from the plane of the shafts.
namespace shafts {
constexpr parameter<"beta"> beta;
constexpr input<"T"> T;
struct First : pin<First, Ground, axis<own::x>, body<1, 0.0 * own::x, inertia<own, 0.3, 1, 1>>> {};
struct Second
    : universal<Second, First, axis<First::y, own::z>, body<1, 0.0 * own::x, inertia<own, 0.2, 0.7, 0.7>>> {};
constexpr auto across = cos(beta) * Ground::y - sin(beta) * Ground::x;
struct System
    : kane_system<
          inertial<Ground>, joints<First, Second>,
          configuration_constraints<zero_along<Second::x, across, Ground::z>>,
          velocity_constraints<zero_along<cross(angular_velocity_of<Second>, Second::x), across, Ground::z>>,
          dependent<q_of<Second, 1>, q_of<Second, 2>, u_of<Second, 1>, u_of<Second, 2>>,
          loads<motor<First, T>>> {};

/// The state in which the first arm is at the angle θ from the plane of the shafts, with ω₁.
state<System> at(double angle, double theta, double rate) {
  // Second::x is along the shaft: in the axes of First it is (cos β, sin β cos θ, −sin β sin θ)
  const double c = std::cos(angle), s = std::sin(angle);
  const Vector3d x(c, s * std::cos(theta), -s * std::sin(theta));
  state<System> found;
  found[q_of<First>] = theta;
  found[q_of<Second, 2>] = std::asin(x.y());          // about own z
  found[q_of<Second, 1>] = std::atan2(-x.z(), x.x()); // about First::y
  found[u_of<First>] = rate;
  return found;
}
} // namespace shafts

TEST(universal, couples_shafts_as_the_textbooks_say) {
  using namespace shafts;
  using eom = equations_of_motion<System>;
  const double b = 0.5, torque = 1.9;
  const parameter_values<System> p(b);
  const input_values<System> r(torque);
  for (const double theta : {0.0, 0.4, 1.1, 1.5}) {
    auto x = at(b, theta, 3.0);
    ASSERT_LT(eom::configuration_residual(x, p).norm(), 1e-14);
    x.tail<2>() = eom::dependent_speeds(x, p);
    const double ratio = std::cos(b) / (1 - std::pow(std::sin(b) * std::cos(theta), 2));
    const Vector3d w = function<System, angular_velocity_of<Second>>{}(x, p);
    const Vector3d out(std::cos(b), std::sin(b), 0);
    EXPECT_NEAR(w.dot(out), 3 * ratio, 1e-13);
    EXPECT_LT((w - 3 * ratio * out).norm(), 1e-13);

    // The cross transmits a torque only along its normal, which acts on both shafts.
    const auto carried = reactions_of<System, Second>(x, p, r);
    const Vector3d first_arm = function<System, First::y>{}(x, p),
                   second_arm = function<System, Second::z>{}(x, p);
    const Vector3d normal = first_arm.cross(second_arm);
    EXPECT_NEAR(first_arm.dot(second_arm), 0, 1e-14);
    const Eigen::Matrix3d R = (Eigen::Matrix3d() << function<System, Second::x>{}(x, p),
                               function<System, Second::y>{}(x, p), second_arm)
                                  .finished();
    const Vector3d on_second = R * carried.torque;
    EXPECT_LT(on_second.cross(normal).norm(), 1e-12);
    const auto a = eom::udot(x, p, r);
    const Vector3d alpha = function<System, angular_acceleration_of<Second>>{}(x, p, r);
    EXPECT_NEAR(on_second.dot(out), 0.2 * alpha.dot(out), 1e-12);
    EXPECT_NEAR(on_second.x(), torque - 0.3 * a[0], 1e-12);
  }
}

} // namespace
