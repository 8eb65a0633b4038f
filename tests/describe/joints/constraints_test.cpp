// builds: clang++
#include "describe/joints/by_hand.hpp"

#include <Eigen/Geometry>

// Constraints of machines, compared with the motions that they permit.
namespace {

using namespace by_hand;

// Two flywheels coupled by gears, with a rack and a belt to a third flywheel.
template <int i>
struct Wheel : pin<Wheel<i>, Ground, axis<own::z>, body<1, 0.0 * own::x, inertia<own, 1, 1, 0.1 * i>>> {};
struct Rack : prismatic<Rack, Ground, axis<own::x>, body<3, 0.0 * own::x>> {};
struct Geared
    : kane_system<
          inertial<Ground>, joints<Wheel<1>, Wheel<2>, Wheel<3>, Rack>,
          configuration_constraints<gear<Wheel<1>, Wheel<2>, -2>, belt<Wheel<2>, Wheel<3>, 0.3, 0.2>,
                                    rack_and_pinion<Rack, Wheel<2>, 0.5>>,
          dependent<q_of<Wheel<1>>, q_of<Wheel<3>>, q_of<Rack>, u_of<Wheel<1>>, u_of<Wheel<3>>, u_of<Rack>>,
          loads<motor<Wheel<2>>>> {};

TEST(constraints, couple_joints) {
  state<Geared> x;
  x[u_of<Wheel<2>>] = 1;
  const auto a = equations_of_motion<Geared>::udot(x, parameter_values<Geared>(), input_values<Geared>(2.0));
  // everything reflected to the second wheel: −2 turns of the first, 3/2 of the third, half a meter per
  // radian
  const double inertia = 0.2 + 4 * 0.1 + 2.25 * 0.3 + 0.25 * 3;
  EXPECT_NEAR(a[1], 2 / inertia, 1e-14);
  EXPECT_NEAR(a[0], -2 * a[1], 1e-14);
  EXPECT_NEAR(a[2], 1.5 * a[1], 1e-14);
  EXPECT_NEAR(a[3], 0.5 * a[1], 1e-14);
}

// A ring of radius r with tube radius s that rolls upright and straight under a torque: T / (I + m (r + s)²).
struct Ring : floating<Ring, Ground, body<2, 0.0 * own::x, inertia<own, 0.3, 0.5, 0.3>>> {};
struct Rolling : kane_system<inertial<Ground>, joints<Ring>,
                             configuration_constraints<touches<Ring, Ground, Ring::y, 0.4, 0.05>>,
                             velocity_constraints<rolls_on<Ring, Ground, Ring::y, 0.4, 0.05>>,
                             dependent<q_of<Ring, 3>, u_of<Ring, 1>, u_of<Ring, 2>, u_of<Ring, 3>>,
                             loads<gravity<-9.81 * Ground::z>, torque<Ring, 1.5 * Ring::y>>> {};

TEST(constraints, let_a_wheel_roll) {
  using eom = equations_of_motion<Rolling>;
  state<Rolling> x;
  x[q_of<Ring, 3>] = 0.45;
  x[q_of<Ring, 7>] = 1;
  x[u_of<Ring, 5>] = 2; // about y, so that it moves along x
  x[u_of<Ring, 1>] = 0.9;
  EXPECT_LT(eom::constraint_residual(x).norm(), 1e-14);
  const auto a = eom::udot(x);
  EXPECT_TRUE(a.status) << a.status.cause();
  EXPECT_NEAR(a[4], 1.5 / (0.5 + 2 * 0.45 * 0.45), 1e-13);
  EXPECT_NEAR(a[0], 0.45 * a[4], 1e-13);
  x[u_of<Ring, 1>] = 0.8;
  EXPECT_NEAR(eom::velocity_residual(x).norm(), 0.1, 1e-14);
  x[q_of<Ring, 3>] = 0.5;
  EXPECT_NEAR(eom::configuration_residual(x)[0], 0.05, 1e-14);
}

// On a table that slides and rotates, a wheel that does not spin relative to the table is at rest on it.
struct Slide : prismatic<Slide, Ground, axis<Ground::x>> {};
struct Table
    : pin<Table, Slide, axis<own::z>, at<0.1 * Ground::y>, body<3, 0.0 * own::x, inertia<own, 1, 1, 1>>> {};
struct On_table : kane_system<inertial<Ground>, joints<Slide, Table, Ring>,
                              configuration_constraints<touches<Ring, Table, Ring::y, 0.4, 0.05>>,
                              velocity_constraints<rolls_on<Ring, Table, Ring::y, 0.4, 0.05>>,
                              dependent<q_of<Ring, 3>, u_of<Ring, 1>, u_of<Ring, 2>, u_of<Ring, 3>>,
                              loads<gravity<-9.81 * Ground::z>>> {};

TEST(constraints, let_a_wheel_roll_on_what_moves) {
  state<On_table> x;
  x[q_of<Slide>] = 0.3, x[u_of<Slide>] = 0.7, x[u_of<Table>] = -1.3;
  const Eigen::Vector3d table(0.3, 0.1, 0), wheel(0.9, -0.4, 0.45), turning(0, 0, -1.3);
  x[q_of<Ring, 1>] = wheel.x(), x[q_of<Ring, 2>] = wheel.y(), x[q_of<Ring, 3>] = wheel.z(),
               x[q_of<Ring, 7>] = 1;
  const Eigen::Vector3d carried = Eigen::Vector3d(0.7, 0, 0) + turning.cross(wheel - table);
  for (int i = 0; i < 3; ++i) x[x.size() - 6 + i] = carried[i];
  x[u_of<Ring, 6>] = -1.3;
  EXPECT_LT(equations_of_motion<On_table>::velocity_residual(x).norm(), 1e-14);
  const double spin = 2;
  x[u_of<Ring, 5>] = spin, x[u_of<Ring, 1>] += 0.45 * spin;
  EXPECT_LT(equations_of_motion<On_table>::velocity_residual(x).norm(), 1e-14);
}

// A pendulum on a rod of length l: the angle of a bar equals that of a bob in a plane.
struct Bob : planar<Bob, Ground, axis<Ground::x, Ground::y>, body<2, 0.0 * own::x, inertia<own, 1, 1, 1>>> {};
struct Hung
    : kane_system<inertial<Ground>, joints<Bob>, configuration_constraints<rod_of_length<Bob, Ground, 0.8>>,
                  loads<gravity<9.81 * Ground::x>>> {};
struct Loop : pin<Loop, Ground, axis<Ground::z>, at<0.0 * Ground::x, -0.8 * own::x>> {};
struct Closed : kane_system<inertial<Ground>, joints<Bob, Loop>,
                            configuration_constraints<coincident<Bob, Loop, Ground::x, Ground::y>>,
                            loads<gravity<9.81 * Ground::x>>> {};

TEST(constraints, hang_a_bob_on_a_rod) {
  state<Hung> x;
  const double angle = 0.6, rate = 1.1;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), across(-std::sin(angle), std::cos(angle));
  x.segment<2>(0) = 0.8 * along;
  x.segment<2>(3) = 0.8 * rate * across;
  EXPECT_LT(equations_of_motion<Hung>::constraint_residual(x).norm(), 1e-14);
  const Eigen::Vector2d expected = -9.81 * std::sin(angle) * across - 0.8 * rate * rate * along;
  EXPECT_LT((equations_of_motion<Hung>::udot(x).head<2>() - expected).norm(), 1e-13);
  const double tension = -2 * 0.8 * equations_of_motion<Hung>::multipliers(x)[0];
  EXPECT_NEAR(tension, 2 * (9.81 * std::cos(angle) + 0.8 * rate * rate), 1e-12);

  state<Closed> y;
  y.segment<2>(0) = x.segment<2>(0);
  y[q_of<Loop>] = angle;
  y.segment<2>(4) = x.segment<2>(3);
  y[u_of<Loop>] = rate;
  EXPECT_LT(equations_of_motion<Closed>::constraint_residual(y).norm(), 1e-14);
  EXPECT_LT((equations_of_motion<Closed>::udot(y).head<2>() - expected).norm(), 1e-13);
}

// The reaction in the bar's pivot in the loop, also if velocities specify the rate of the constraint.
struct Said_twice
    : extended<Closed,
               velocity_constraints<zero_along<velocity_of<Bob> - velocity_of<Loop>, Ground::x, Ground::y>>> {
};

template <class System>
void expect_bar_carries_tension() {
  state<System> y;
  const double angle = 0.6, rate = 1.1;
  y.template segment<2>(0) << 0.8 * std::cos(angle), 0.8 * std::sin(angle);
  y[q_of<Loop>] = angle;
  y.template segment<2>(4) << -0.8 * rate * std::sin(angle), 0.8 * rate * std::cos(angle);
  y[u_of<Loop>] = rate;
  ASSERT_LT(equations_of_motion<System>::constraint_residual(y).norm(), 1e-14);
  const auto carried = reactions_of<System, Loop>(y);
  const double tension = 2 * (9.81 * std::cos(angle) + 0.8 * rate * rate);
  EXPECT_NEAR(carried.force.x(), -tension, 1e-12); // the bar is massless and points away from the pivot
  EXPECT_NEAR(carried.force.y(), 0, 1e-12);
  EXPECT_LT(carried.torque.norm(), 1e-12);
}

TEST(constraints, load_the_joints_of_a_loop) {
  expect_bar_carries_tension<Closed>();
  expect_bar_carries_tension<Said_twice>();
}

} // namespace
