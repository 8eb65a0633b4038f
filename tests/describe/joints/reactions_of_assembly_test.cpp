// builds: clang++ all
// Reactions of joints that do not occur in a chain of pins and balls, compared with the Newton-Euler
// equations: planar, sliding, welded and universal joints.
#include "describe/joints/newton_euler.hpp"

namespace {

using namespace by_hand;

struct Puck : planar<Puck, Ground, axis<own::x, own::y>, seat, home<0.3, Ground::x>, load> {};
struct Slide : prismatic<Slide, Puck, axis<Puck::x + Puck::z>, at<0.1 * Puck::y>, load> {};
struct Bracket : weld<Bracket, Slide, at<0.2 * Slide::x, 0.3 * own::y>, home<0.6, Slide::y>, load> {};
struct Hook : universal<Hook, Bracket, axis<Bracket::x, own::z>, at<0.1 * Bracket::z, 0.2 * own::x>, load> {};
struct Assembly
    : kane_system<inertial<Ground>, joints<Puck, Slide, Bracket, Hook>, loads<weight, motor<Slide>>> {};
struct Puck_seat : offset<Puck_seat, Puck, 0.4 * Puck::x - 0.1 * Puck::y> {};
struct Hook_seat : offset<Hook_seat, Hook, 0.2 * Hook::x> {};

TEST(reactions, keep_an_assembly_moving_by_newton_and_euler) {
  state<Assembly> x;
  x << 0.4, -0.7, 0.3, 0.1, -0.5, 0.2, 0.9, 1.3, -0.6, 0.9, 0.8, -1.1;
  const parameter_values<Assembly> p;
  const input_values<Assembly> F(2.1);
  const Vector3d none = Vector3d::Zero();
  expect_newton_and_euler<Assembly, Puck, Puck_seat, Slide, Bracket, Hook>(none, x, p, F);
  expect_newton_and_euler<Assembly, Hook, Hook_seat>(none, x, p, F);
  const auto sliding = reactions_of<Assembly, Slide>(x, p, F);
  EXPECT_NEAR(sliding.force.x() + sliding.force.z(), 0, 1e-12);
}

} // namespace
