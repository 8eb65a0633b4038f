// builds: clang++ sanitize no-exceptions
#include "describe/joints/by_hand.hpp"

#include <cmath>

// Joints that rotate about axes, with locations away from both points.
namespace {

using namespace by_hand;

namespace hinge {
struct Link : pin<Link, Ground, axis<own::y>, seat, home<0.7, Ground::z>, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
struct Home : rotated<Home, Ground, 0.7, Ground::z> {};
struct Child : rotated<Child, Home, q, Home::y> {};
struct Joint : offset<Joint, Ground, seat::in_parent> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Body>,
                          loads<weight>> {};
} // namespace hinge

TEST(pin, is_a_turn_about_its_axis) { expect_same_motion<hinge::System, hinge::Hand>(); }

namespace driven {
struct Link : pin<Link, Ground, axis<own::y>, seat, home<0.7, Ground::z>, load, stops<-0.2, 0.0, 40, 0.2>,
                  rotor<0.02, 7>> {};
struct System : kane_system<inertial<Ground>, joints<Link>,
                            loads<weight, linear_spring<Link, 3, 0.2>, linear_damper<Link, 0.4>>> {};

using hinge::q, hinge::u, hinge::Body, hinge::Child;
struct Rotor_axes : rotated<Rotor_axes, Ground, 7 * q, Ground::z> {};
struct Rotor
    : rigid_body<Rotor, Ground, Rotor_axes, 0.0, effective_inertia<inertia<Rotor_axes, 0.0, 0.0, 0.02>>> {};
struct Hand
    : kane_system<inertial<Ground>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Body, Rotor>,
                  loads<weight, torsional_spring<q, 3, 0.2>, torsional_damper<Child, Ground, 0.4>,
                        stop<given_length<q>, -0.2, 0.0, 40, 0.2>>> {};
struct By_lagrange
    : lagrange_system<inertial<Ground>, joints<driven::Link>,
                      loads<weight, linear_spring<driven::Link, 3, 0.2>, linear_damper<driven::Link, 0.4>>> {
};
} // namespace driven

TEST(pin, has_stops_and_a_rotor) {
  using driven_system = driven::System;
  expect_same_motion<driven_system, driven::Hand>();
  for (const double angle : {-0.3, -0.1, 0.2}) {
    const auto by_kane = equations_of_motion<driven_system>::udot(state<driven_system>(angle, -0.7));
    const auto by_lagrange =
        equations_of_motion<driven::By_lagrange>::udot(state<driven::By_lagrange>(angle, -0.7));
    EXPECT_NEAR(by_kane[0], by_lagrange[0], 1e-12 * std::abs(by_kane[0]));
  }
}

namespace ball {
struct Link : spherical<Link, Ground, seat, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"w1"> w1;
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
struct Child : quaternion<Child, Ground, e0, e1, e2, e3>,
               angular_velocity<Ground, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct Joint : offset<Joint, Ground, seat::in_parent> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<e1, e2, e3, e0>, speeds<w1, w2, w3>,
                          kinematics<kinematics_of<Child, Ground>>, bodies<Body>, loads<weight>> {};
} // namespace ball

TEST(spherical, turns_by_a_unit_quaternion) { expect_same_motion<ball::System, ball::Hand>(); }

namespace ball_by_angles {
struct Link : spherical<Link, Ground, angles<"zxz">, seat, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"a"> a;
constexpr coordinate<"b"> b;
constexpr coordinate<"c"> c;
using ball::w1, ball::w2, ball::w3;
struct Child : body_fixed<Child, Ground, "zxz", a, b, c>,
               angular_velocity<Ground, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct Joint : offset<Joint, Ground, seat::in_parent> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<a, b, c>, speeds<w1, w2, w3>,
                          kinematics<kinematics_of<Child, Ground>>, bodies<Body>, loads<weight>> {};
} // namespace ball_by_angles

TEST(spherical, turns_by_three_angles) { expect_same_motion<ball_by_angles::System, ball_by_angles::Hand>(); }

// By Lagrange's method, the speeds of a joint are the rates of its coordinates.
struct By_lagrange : lagrange_system<inertial<Ground>, joints<hinge::Link>, loads<weight>> {};

TEST(joints, serve_both_methods) {
  const auto by_kane = equations_of_motion<hinge::System>::udot(state<hinge::System>(0.4, -0.7));
  const auto by_lagrange = equations_of_motion<By_lagrange>::udot(state<By_lagrange>(0.4, -0.7));
  EXPECT_NEAR(by_kane[0], by_lagrange[0], 1e-13);
}

// Names chosen by joints, and names chosen by the user.
constexpr coordinate<"alpha"> alpha;
constexpr speed<"omega"> omega;
struct Upper : pin<Upper, Ground, axis<Ground::y>, load, by<alpha, omega>> {};
template <int i>
struct Lower : pin<Lower<i>, Upper, axis<Upper::z>, at<0.5 * Upper::x>> {};

template <class A, class B>
constexpr bool same = std::is_same_v<std::remove_cvref_t<A>, B>;
static_assert(same<decltype(q_of<Upper>), coordinate<"alpha">> &&
              same<decltype(u_of<Upper>), speed<"omega">>);
static_assert(same<decltype(q_of<Lower<3>>), coordinate<"q_Lower_3">>);
static_assert(same<decltype(u_of<Lower<3>>), speed<"u_Lower_3">>);
static_assert(same<decltype(effort_of<Lower<3>>), input<"T_Lower_3">>);
static_assert(same<decltype(q_of<ball::Link, 4>), coordinate<"e0_Link">>);
static_assert(same<decltype(u_of<ball::Link, 2>), speed<"w2_Link">>);

// Welded parts move as one body.
struct Arm : pin<Arm, Ground, axis<Ground::y>, load> {};
struct Tool : weld<Tool, Arm, at<0.2 * Arm::y>, home<0.3, Arm::x>, load> {};
struct Tooled : kane_system<inertial<Ground>, joints<Arm, Tool>, loads<weight, motor<Arm>>> {};

struct Tool_frame : rotated<Tool_frame, Arm, 0.3, Arm::x> {};
struct Tool_point : offset<Tool_point, Arm, 0.2 * Arm::y> {};
struct Tool_center : offset<Tool_center, Tool_point, center_of<Tool_frame>> {};
struct Tool_body : load_of<Tool_body, Tool_center, Tool_frame> {};
struct By_hand : kane_system<inertial<Ground>, joints<Arm>, bodies<Tool_body>,
                             loads<weight, torque<Arm, effort_of<Arm> * Ground::y>>> {};

TEST(weld, adds_its_body_to_the_parent) {
  const auto tooled = equations_of_motion<Tooled>::udot(state<Tooled>(0.4, -0.7), parameter_values<Tooled>(),
                                                        input_values<Tooled>(1.3));
  const auto by_hand = equations_of_motion<By_hand>::udot(
      state<By_hand>(0.4, -0.7), parameter_values<By_hand>(), input_values<By_hand>(1.3));
  EXPECT_NEAR(tooled[0], by_hand[0], 1e-14);
}

} // namespace
