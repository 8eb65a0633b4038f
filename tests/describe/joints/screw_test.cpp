// builds: clang++ sanitize
#include "describe/joints/by_hand.hpp"

namespace {

using namespace by_hand;

namespace nut {
struct Link : screw<Link, Ground, axis<Ground::y>, pitch<0.15>, seat, home<0.7, Ground::y>, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight, joint_friction<Link, 0.2>>> {};

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
struct Home : rotated<Home, Ground, 0.7, Ground::y> {};
struct Child : rotated<Child, Home, q, Home::y> {};
struct Base : offset<Base, Ground, seat::in_parent> {};
struct Joint : offset<Joint, Base, 0.15 * q * Ground::y> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q>, speeds<u>, kinematics<simple>, bodies<Body>,
                          loads<weight, torque<Child, -0.2 * u * Ground::y>>> {};
} // namespace nut

TEST(screw, turns_as_it_goes) { expect_same_motion<nut::System, nut::Hand>(); }

// A nut that moves down a vertical spindle: (I + m h²) q̈ = m g h; the thread carries a force F along the
// axis and a torque −h F about it.
namespace spindle {
constexpr parameter<"h"> h;
struct Nut
    : screw<Nut, Ground, axis<Ground::z>, pitch<h>, body<0.7, 0.0 * own::x, inertia<own, 1, 1, 0.02>>> {};
struct System : kane_system<inertial<Ground>, joints<Nut>, loads<gravity<9.81 * Ground::z>>> {};
} // namespace spindle

TEST(screw, runs_down_a_spindle) {
  using namespace spindle;
  const double advance = 0.3, inertia = 0.02 + 0.7 * advance * advance;
  const state<System> x(0.4, 2.0);
  const parameter_values<System> p(advance);
  const double expected = 0.7 * 9.81 * advance / inertia;
  EXPECT_NEAR((equations_of_motion<System>::udot(x, p)[0]), expected, 1e-12);
  const auto carried = reactions_of<System, Nut>(x, p);
  const double along = 0.7 * (advance * expected - 9.81);
  EXPECT_NEAR(carried.force.z(), along, 1e-12);
  EXPECT_NEAR(carried.torque.z(), -advance * along, 1e-12);
}

} // namespace
