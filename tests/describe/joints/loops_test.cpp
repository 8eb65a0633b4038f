// builds: clang++ all
// Loops that are closed by a pin or a weld, compared with the same mechanism without a loop.
#include "describe/joints/by_hand.hpp"

namespace {

using namespace by_hand;

struct Arm : pin<Arm, Ground, axis<own::x>, seat, load> {};
struct Place : offset<Place, Arm, 0.3 * Arm::x + 0.2 * Arm::z> {};

// A floating plate whose z axis and one of whose points are constrained to the arm, and a plate attached by a
// joint.
struct Held : floating<Held, Ground, angles<"xyz">, load> {};
struct Held_at : offset<Held_at, Held, 0.1 * Held::y> {};
struct Hung : pin<Hung, Arm, axis<own::z>, at<0.3 * Arm::x + 0.2 * Arm::z, 0.1 * own::y>, load> {};
struct Fixed : weld<Fixed, Arm, at<0.3 * Arm::x + 0.2 * Arm::z, 0.1 * own::y>, load> {};

template <auto... closing>
using closed = kane_system<
    inertial<Ground>, joints<Arm, Held>, loads<weight, motor<Arm>>,
    configuration_constraints<coincident<Held_at, Place, Ground::x, Ground::y, Ground::z>, closing...>>;
struct By_pin : extended<closed<parallel<Held::z, Arm::z>>, reactions<Arm>> {};
struct By_weld : closed<same_axes<Held, Arm>> {};
struct Pinned : kane_system<inertial<Ground>, joints<Arm, Hung>, loads<weight, motor<Arm>>, reactions<Arm>> {
};
struct Welded : kane_system<inertial<Ground>, joints<Arm, Fixed>, loads<weight, motor<Arm>>> {};

/// The position in which the floating plate coincides with the attached one.
template <class Closed, class Open, class Plate>
state<Closed> closed_at(const state<Open>& x) {
  const auto [at, axis_x, axis_y, axis_z, v, w] =
      function<Open, position_of<Plate, Ground>, Plate::x, Plate::y, Plate::z, velocity_of<Plate>,
               angular_velocity_of<Plate>>{}(x);
  const Eigen::Matrix3d R = (Eigen::Matrix3d() << axis_x, axis_y, axis_z).finished();
  state<Closed> y;
  y[q_of<Arm>] = x[q_of<Arm>], y[u_of<Arm>] = x[u_of<Arm>];
  y[q_of<Held, 1>] = at.x(), y[q_of<Held, 2>] = at.y(), y[q_of<Held, 3>] = at.z();
  y[q_of<Held, 4>] = std::atan2(-R(1, 2), R(2, 2));
  y[q_of<Held, 5>] = std::asin(R(0, 2));
  y[q_of<Held, 6>] = std::atan2(-R(0, 1), R(0, 0));
  y.template tail<6>() << R.transpose() * v, R.transpose() * w;
  return y;
}

template <class Closed, class Open>
void expect_same_motion_of_arm(const state<Closed>& y, const state<Open>& x) {
  EXPECT_LT(equations_of_motion<Closed>::constraint_residual(y).norm(), 1e-14);
  const auto a = equations_of_motion<Closed>::udot(y, parameter_values<Closed>(), input_values<Closed>(1.7));
  EXPECT_TRUE(a.status) << a.status.cause();
  const auto expected = equations_of_motion<Open>::udot(x, parameter_values<Open>(), input_values<Open>(1.7));
  EXPECT_NEAR(a[0], expected[0], 1e-12 * (1 + expected.norm()));
}

// The bearing of the arm carries the same load even though the plate is attached only by constraints.
TEST(loops, are_closed_by_a_pin) {
  state<Pinned> x;
  x << 0.4, -0.7, 1.3, -0.9;
  const auto y = closed_at<By_pin, Pinned, Hung>(x);
  expect_same_motion_of_arm(y, x);
  const auto held = equations_of_motion<By_pin>::noncontributing_forces(y, parameter_values<By_pin>(),
                                                                        input_values<By_pin>(1.7));
  const auto hung = equations_of_motion<Pinned>::noncontributing_forces(x, parameter_values<Pinned>(),
                                                                        input_values<Pinned>(1.7));
  ASSERT_EQ(held.size(), 6);
  EXPECT_LT((held - hung).norm(), 1e-12 * hung.norm());
}

TEST(loops, are_closed_by_a_weld) {
  state<Welded> x;
  x << 0.8, 1.3;
  expect_same_motion_of_arm(closed_at<By_weld, Welded, Fixed>(x), x);
}

} // namespace
