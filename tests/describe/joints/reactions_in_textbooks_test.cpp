// builds: clang++ all
// Joint reactions, compared with textbook formulas.
#include "describe/joints/by_hand.hpp"

namespace {

using namespace by_hand;
using Eigen::Vector3d;

// A slender rod of length 2 a on a ball joint that rotates steadily at an angle from the vertical: ω² = 3 g /
// (4 a cos θ); the joint carries the weight and m ω² a sin θ toward the axis (Meriam & Kraige, Dynamics, the
// conical pendulum).
struct Rod
    : spherical<Rod, Ground, angles<"zxz">, body<1.5, -0.6 * own::z, inertia<own, 0.18, 0.18, 0.0001>>> {
}; // m (2 a)²/12
struct Conical : kane_system<inertial<Ground>, joints<Rod>, loads<gravity<-9.81 * Ground::z>>> {};

TEST(reactions, of_a_ball_are_those_of_a_conical_pendulum) {
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  // without spin about itself; its inertia about its own axis is not zero: I ω sin θ cos θ = m g a sin θ
  const double inertia = 0.18 + 1.5 * 0.6 * 0.6 - 0.0001, rate = std::sqrt(1.5 * 9.81 * 0.6 / (inertia * c));
  EXPECT_NEAR(rate * rate, 3 * 9.81 / (4 * 0.6 * c), 1e-2);
  state<Conical> x;
  x << 0, angle, 0, 0, rate * s, rate * c; // rotated about x; the rate is about the vertical
  const auto rates = equations_of_motion<Conical>::rhs(x);
  EXPECT_NEAR(rates[0], rate, 1e-12); // steadily
  EXPECT_NEAR(rates[1], 0, 1e-12);
  EXPECT_NEAR(rates[3], 0, 1e-12);
  const auto carried = reactions_of<Conical, Rod>(x);
  const Eigen::Matrix3d R = (Eigen::Matrix3d() << 1, 0, 0, 0, c, -s, 0, s, c).finished();
  const Vector3d force = R * carried.force;
  EXPECT_NEAR(force.z(), 1.5 * 9.81, 1e-12);
  EXPECT_NEAR(force.y(), -1.5 * rate * rate * 0.6 * s, 1e-12);
  EXPECT_NEAR(force.x(), 0, 1e-12);
  EXPECT_LT(carried.torque.norm(), 1e-12);
}

// An unbalanced rotor in a bearing that lets it slide: m e ω² perpendicular to the axis, and, about the
// transverse axes, the products of inertia times ω² (Meriam & Kraige, Dynamics, rotation about a fixed axis).
struct Rotor : cylindrical<Rotor, Ground, axis<own::z>,
                           body<3, 0.02 * own::x, inertia<own, 0.4, 0.5, 0.6, 0, 0.011, -0.023>>> {};
struct Turning : kane_system<inertial<Ground>, joints<Rotor>> {};

TEST(reactions, of_a_cylindrical_joint_are_those_of_a_rotor_out_of_balance) {
  state<Turning> x;
  const double rate = 31;
  x << 0.4, 0.1, rate, 0.5;
  const auto carried = reactions_of<Turning, Rotor>(x);
  EXPECT_LT((carried.force - Vector3d(-3 * 0.02 * rate * rate, 0, 0)).norm(), 1e-11);
  // ω × I ω with I ω = ω (Ixz, Iyz, Izz), about the mass center, which is at the height of the joint
  EXPECT_LT((carried.torque - Vector3d(-0.011, -0.023, 0) * rate * rate).norm(), 1e-11);
}

} // namespace
