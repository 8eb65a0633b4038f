// builds: clang++ sanitize all
// Reactions of the joints of a chain, compared with the Newton-Euler equations.
#include "describe/joints/newton_euler.hpp"

namespace {

using namespace by_hand;

// A chain of three joints: a pin with a motor and friction, a cylindrical joint and a ball.
struct Turret : pin<Turret, Ground, axis<own::z>, seat, load> {};
struct Sleeve : cylindrical<Sleeve, Turret, axis<Turret::x>, at<0.3 * Turret::y, 0.2 * own::z>, load> {};
struct Ball : spherical<Ball, Sleeve, at<0.2 * Sleeve::x, -0.5 * own::y>, home<0.4, Sleeve::z>, load> {};
struct Chain : kane_system<inertial<Ground>, joints<Turret, Sleeve, Ball>,
                           loads<weight, motor<Turret>, joint_friction<Turret, 0.35>>> {};

struct Turret_seat : offset<Turret_seat, Turret, 0.4 * Turret::x - 0.1 * Turret::y> {};
struct Sleeve_seat : offset<Sleeve_seat, Sleeve, 0.2 * Sleeve::z> {};
struct Ball_seat : offset<Ball_seat, Ball, -0.5 * Ball::y> {};

TEST(reactions, keep_bodies_moving_by_newton_and_euler) {
  state<Chain> x;
  x << 0.4, -0.7, 0.3, 0.1, -0.5, 0.2, 0, 1.3, -0.6, 0.9, 0.8, -1.1, 0.5;
  x[q_of<Ball, 4>] = std::sqrt(1 - x.segment<3>(3).squaredNorm());
  const parameter_values<Chain> p;
  const input_values<Chain> T(1.7);
  const Vector3d driven(0, 0, 1.7 - 0.35 * 1.3);
  expect_newton_and_euler<Chain, Turret, Turret_seat, Sleeve, Ball>(driven, x, p, T);
  expect_newton_and_euler<Chain, Sleeve, Sleeve_seat, Ball>(Vector3d::Zero(), x, p, T);
  expect_newton_and_euler<Chain, Ball, Ball_seat>(Vector3d::Zero(), x, p, T);
}

TEST(reactions, are_zero_along_what_is_free) {
  state<Chain> x;
  x << 0.4, -0.7, 0.3, 0.1, -0.5, 0.2, 0.83, 1.3, -0.6, 0.9, 0.8, -1.1, 0.5;
  const parameter_values<Chain> p;
  const input_values<Chain> T(1.7);
  EXPECT_NEAR((reactions_of<Chain, Turret>(x, p, T).torque.z()), 0, 1e-12);
  const auto sleeve = reactions_of<Chain, Sleeve>(x, p, T);
  EXPECT_NEAR(sleeve.torque.x(), 0, 1e-12);
  EXPECT_NEAR(sleeve.force.x(), 0, 1e-12);
  EXPECT_GT(std::abs(sleeve.force.y()), 0.1);
  EXPECT_LT((reactions_of<Chain, Ball>(x, p, T).torque.norm()), 1e-12);
}

} // namespace
