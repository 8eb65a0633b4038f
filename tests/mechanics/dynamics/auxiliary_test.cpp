// builds: clang++
// Forces that do no work, brought into evidence by auxiliary speeds, compared with Newton's and Euler's laws
// written by hand.
#include "mechanics/workbench.hpp"

#include <Eigen/Geometry>

namespace {

using namespace workbench;

VectorXd found(bench& b, mechanics::equations& e, quantity q) { return b.numbers(e.get(q)); }

// A rod with some inertia on a pin, with a force at its end.
TEST(auxiliary_speeds, give_the_force_of_a_pin) {
  bench b(false);
  b.kinematic_equation(b.dot(b.q[0]) - b.u[0]);
  for (int i = 1; i < 3; ++i) b.kinematic_equation(b.dot(b.q[i]) - b.u[i]);
  const expression zero = b.number(0.0), along_x = b.auxiliary_speed("ax"), along_y = b.auxiliary_speed("ay");
  const point_id pin = b.offset("Pin", b.o, vector());
  b.velocity(pin, b.n, b.along(b.n, along_x, along_y, zero));
  const frame_id rod = b.rotated("Rod", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const double mass = 1.7, inertia = 0.4, to_center = 0.6, to_end = 1.3;
  const point_id center = b.offset("G", pin, b.along(rod, to_center, 0, 0)),
                 end = b.offset("E", pin, b.along(rod, to_end, 0, 0));
  b.rigid_body("Body", center, rod, b.number(mass), b.inertia(rod, zero, zero, b.number(inertia)));
  b.particle("Elsewhere", b.offset("B", b.o, b.along(b.n, zero, b.q[1], b.q[2])), b.number(1));
  const Vector3d pull(2, -0.7, 0), weight(0, -9.81 * mass, 0);
  b.gravity(b.along(b.n, 0, -9.81, 0));
  b.force(end, b.along(b.n, pull(0), pull(1), 0));
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());

  const Vector3d x(std::cos(b.q_now[0]), std::sin(b.q_now[0]), 0), z = Vector3d::UnitZ();
  const double turning = (to_center * x).cross(weight).z() + (to_end * x).cross(pull).z();
  const double alpha = turning / (inertia + mass * to_center * to_center), omega = b.u_now[0];
  const Vector3d acceleration = to_center * (alpha * z.cross(x) - omega * omega * x);
  const Vector3d pin_force = mass * acceleration - weight - pull;
  expect_equal(found(b, e, quantity::udot).head(1), VectorXd::Constant(1, alpha));
  expect_equal(found(b, e, quantity::noncontributing_forces), pin_force.head(2));
  // nothing else depends on them
  expect_equal(b.in_ground(mechanics::velocity_of_point(e.moving(), place(center))),
               to_center * omega * z.cross(x));
}

// Loads that act at a velocity that contains auxiliary speeds act as if these were absent.
TEST(auxiliary_speeds, are_zero_in_loads) {
  MatrixXd udot[2], force[2];
  for (const bool held : {false, true}) {
    bench b;
    const expression lift = b.auxiliary_speed("lift"), zero = b.number(0.0);
    const point_id p = b.offset("P", b.o, b.along(b.n, b.q[0], b.q[1], zero));
    b.velocity(p, b.n, b.along(b.n, b.u[0], b.u[1], lift));
    b.particle("Bead", p, b.number(1));
    const expression drag = held ? lift : zero;
    b.force(p, b.along(b.n, drag - b.u[0], drag * b.u[1], b.number(3) - 2 * drag));
    b.torque(b.rotated("A", b.n, b.q[2], b.along(b.n, 0, 0, 1)), b.along(b.n, zero, zero, drag));
    ASSERT_EQ(b.check().view(), "");
    mechanics::equations e(b.system());
    udot[held] = found(b, e, quantity::udot);
    force[held] = found(b, e, quantity::noncontributing_forces);
  }
  expect_equal(udot[1], udot[0]);
  expect_equal(force[1], force[0]);
  expect_equal(force[0], VectorXd::Constant(1, -3));
}

// A rotor with any inertia that spins in a frame rotated by a torque: the bearings hold it in two directions.
TEST(auxiliary_speeds, give_the_torque_of_bearings) {
  bench b(false);
  for (int i = 0; i < 3; ++i) b.kinematic_equation(b.dot(b.q[i]) - b.u[i]);
  const expression zero = b.number(0.0), about_y = b.auxiliary_speed("ay"), about_z = b.auxiliary_speed("az");
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const frame_id rotor = b.rotated("R", a, b.q[1], b.along(a, 1, 0, 0));
  b.angular_velocity(rotor, a, b.along(a, b.u[1], about_y, about_z));
  const double carrier = 0.9, torque = 3.3;
  const Vector3d principal(0.5, 0.8, 1.1);
  b.rigid_body("Carrier", b.o, a, b.number(1), b.inertia(a, zero, zero, b.number(carrier)));
  b.rigid_body("Rotor", b.o, rotor, b.number(1),
               b.inertia(rotor, b.number(principal(0)), b.number(principal(1)), b.number(principal(2))));
  b.particle("Elsewhere", b.offset("B", b.o, b.along(b.n, b.q[2], zero, zero)), b.number(1));
  b.torque(a, b.along(a, 0, 0, torque));
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());

  // in A's axes: ω = u1 x + u0 z, and α = u̇1 x + u̇0 z + u0 z × u1 x
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  const Matrix3d turn = Eigen::AngleAxisd(b.q_now[1], x).toRotationMatrix();
  const Matrix3d inertia = turn * principal.asDiagonal() * turn.transpose();
  const Vector3d omega = b.u_now[1] * x + b.u_now[0] * z;
  const Vector3d rest = inertia * (b.u_now[0] * b.u_now[1] * z.cross(x)) + omega.cross(inertia * omega);
  // no torque acts on the rotor about x; about z the rotor takes from the carrier what the torque does not
  // provide
  Eigen::Matrix2d m;
  m << inertia(2, 2) + carrier, inertia(2, 0), inertia(0, 2), inertia(0, 0);
  const Eigen::Vector2d udot = m.inverse() * Eigen::Vector2d(torque - rest(2), -rest(0));
  const Vector3d on_rotor = inertia * (udot(1) * x + udot(0) * z) + rest;
  EXPECT_NEAR(on_rotor(0), 0, 1e-14);
  expect_equal(found(b, e, quantity::udot).head(2), udot);
  expect_equal(found(b, e, quantity::noncontributing_forces), on_rotor.tail(2));
}

// ---- the rolling disc: what acts where it touches the ground is m a less its weight

struct disc {
  static constexpr double mass = 2, radius = 0.6, across = 0.18, along = 0.36;

  // With the components of the angular velocity in L's axes as the first three speeds.
  static Vector3d contact_force(const bench& b, Vector3d& udot) {
    const Vector3d u = Vector3d::Map(b.u_now), arm = radius * Vector3d::UnitZ();
    const Vector3d omega_l(u(0), u(2) * std::tan(b.q_now[1]), u(2));
    const Matrix3d inertia = Vector3d(across, along, across).asDiagonal();
    Matrix3d partial;
    for (int i = 0; i < 3; ++i) partial.col(i) = Vector3d::Unit(i).cross(arm);
    const Vector3d rest = omega_l.cross(u.cross(arm)), alpha_rest = omega_l.cross(u);
    const Matrix3d to_ground =
        (Eigen::AngleAxisd(b.q_now[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(b.q_now[1], Vector3d::UnitX()))
            .toRotationMatrix();
    const Vector3d weight(0, 0, -9.81 * mass);
    const Matrix3d m = mass * partial.transpose() * partial + inertia;
    udot = m.inverse() * (partial.transpose() * (to_ground.transpose() * weight - mass * rest) -
                          inertia * alpha_rest - u.cross(inertia * u));
    return mass * (to_ground * (udot.cross(arm) + rest)) - weight;
  }

  frame_id yaw, lean, rolling;
  explicit disc(bench& b)
      : yaw(b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1))),
        lean(b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0))),
        rolling(b.rotated("R", lean, b.q[2], b.along(lean, 0, 1, 0))) {
    b.angular_velocity(rolling, b.n, b.along(lean, b.u[0], b.u[1], b.u[2]));
    b.kinematics_of(rolling, b.n);
    b.gravity(b.along(b.n, 0, 0, -9.81));
  }
  void body(bench& b, point_id center) const {
    b.rigid_body("Disc", center, rolling, b.number(mass),
                 b.inertia(lean, b.number(across), b.number(along), b.number(across)));
  }
};

TEST(auxiliary_speeds, give_the_contact_force_of_a_rolling_disc) {
  bench b(false);
  const disc d(b);
  const point_id contact = b.offset("C", b.o, vector());
  const expression ax = b.auxiliary_speed("ax"), ay = b.auxiliary_speed("ay"), az = b.auxiliary_speed("az");
  b.velocity(contact, b.n, b.along(b.n, ax, ay, az));
  const point_id center = b.offset("Dmc", contact, b.along(d.lean, 0, 0, disc::radius));
  b.fixed_in(center, d.rolling);
  d.body(b, center);
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  Vector3d udot;
  const Vector3d force = disc::contact_force(b, udot);
  expect_equal(found(b, e, quantity::udot), udot);
  expect_equal(found(b, e, quantity::noncontributing_forces), force);
}

// Rolling as constraints: the multipliers are forces along the directions in which the rim does not slip, and
// an auxiliary speed lifts the disc. The directions need not be level; if they are not, each force
// contributes to the other equation.
TEST(auxiliary_speeds, share_the_contact_force_with_constraints) {
  for (const double slope : {0.0, 0.3}) {
    SCOPED_TRACE(slope);
    bench b(false);
    const disc d(b);
    const expression zero = b.number(0.0), radius = b.number(disc::radius);
    const expression x = b.coordinate("x"), y = b.coordinate("y"), vx = b.speed("vx"), vy = b.speed("vy");
    b.kinematic_equation(b.dot(x) - vx);
    b.kinematic_equation(b.dot(y) - vy);
    const point_id center = b.offset("Dmc", b.o, b.along(b.n, x, y, radius * cos(b.q[1])));
    b.velocity(center, b.n,
               b.along(b.n, vx, vy, b.auxiliary_speed("lift") - radius * sin(b.q[1]) * b.dot(b.q[1])));
    const point_id contact = b.offset("C", center, b.along(d.lean, zero, zero, -radius));
    b.fixed_in(contact, d.rolling);
    d.body(b, center);
    ASSERT_EQ(b.check().view(), "");
    mechanics::known_motion known(b.mechanism());
    const vector v = mechanics::velocity_of_point(known.moving(), place(contact));
    b.velocity_constraint(v, b.along(b.n, 1, 0, slope));
    b.velocity_constraint(v, b.along(b.n, 0, 1, 0));
    b.dependent(vx);
    b.dependent(vy);
    mechanics::equations e(b.system());
    e.constrain();
    ASSERT_EQ(e.mistake().view(), "");

    Vector3d udot;
    const Vector3d force = disc::contact_force(b, udot);
    const VectorXd u = b.numbers(e.get(quantity::dependent_speeds));
    b.u_now[3] = u(0), b.u_now[4] = u(1);
    expect_equal(found(b, e, quantity::velocity_residual), VectorXd::Zero(2));
    expect_equal(found(b, e, quantity::udot).head(3), udot);
    const VectorXd lambda = found(b, e, quantity::multipliers),
                   lift = found(b, e, quantity::noncontributing_forces);
    expect_equal(Vector3d(lambda(0), lambda(1), lift(0) + slope * lambda(0)), force);
  }
}

} // namespace
