// builds: clang++ all
// Masses and inertias that change, F = d(mv)/dt and M = dH/dt, compared with momenta along the motion as
// Taylor series, and prescribed motion, compared with closed forms.
#include "mechanics/jet.hpp"
#include "mechanics/workbench.hpp"

#include <Eigen/Geometry>

namespace {

using namespace workbench;
using limits::jet;
using limits::jet3;
using limits::jet3x3;

VectorXd found(bench& b, mechanics::equations& e, quantity q) { return b.numbers(e.get(q)); }

// The coordinates of a workbench whose speeds are their rates, along its motion, and the time.
struct course {
  jet q[3], t;
  course(const bench& b, const VectorXd& udot) : t(b.t_now, 1, 0) {
    for (int i = 0; i < 3; ++i) q[i] = {b.q_now[i], b.u_now[i], udot(i) / 2};
  }
};

TEST(mass, may_be_a_function_of_time) {
  bench b;
  const double force = 3, burning = -0.4, full = 2;
  const point_id p = b.offset("P", b.o, b.along(b.n, b.q[0], b.number(0.0), b.number(0.0)));
  const expression mass = b.number(full) + b.number(burning) * b.time();
  b.particle("Rocket", p, mass);
  b.force(p, b.along(b.n, force, 0, 0));
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  const double now = full + burning * b.t_now; // next to the ballast
  expect_equal(found(b, e, quantity::udot), Vector3d((force - burning * b.u_now[0]) / (now + 1), 0, 0));
  expect_equal(found(b, e, quantity::linear_momentum),
               (now + 1) * Vector3d(b.u_now[0], 0, 0) + Vector3d(0, b.u_now[1], b.u_now[2]));
}

// A chain that is pulled off a heap: only the hanging part moves.
TEST(mass, may_be_a_function_of_coordinates) {
  bench b;
  const double density = 1.4;
  const point_id end = b.offset("End", b.o, b.along(b.n, b.number(0.0), b.number(0.0), -b.q[0]));
  b.particle("Chain", end, b.number(density) * b.q[0]);
  b.force(end, b.along(b.n, b.number(0.0), b.number(0.0), b.number(-9.81 * density) * b.q[0]));
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  const double hangs = density * b.q_now[0], v = b.u_now[0];
  expect_equal(found(b, e, quantity::udot).head(1),
               VectorXd::Constant(1, (9.81 * hangs - density * v * v) / (hangs + 1)));
}

// A leaking bucket on a rope that is wound up, in space: v_r · (d(mv)/dt − F) = 0 for each speed.
TEST(mass, obeys_the_law_of_momentum_in_space) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const frame_id c = b.rotated("C", a, b.q[1], b.along(a, 1, 0, 0));
  const expression zero = b.number(0.0);
  const point_id bucket = b.offset("Bucket", b.o, b.along(c, zero, b.number(0.3), b.q[2]));
  const expression leaves = b.time() * (b.number(0.2) + sin(b.q[1])), mass = 4 - leaves + b.q[2] * b.q[2];
  b.particle("Water", bucket, mass);
  const Vector3d force(0.3, -1, 2);
  b.force(bucket, b.along(b.n, force(0), force(1), force(2)));
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  const VectorXd udot = found(b, e, quantity::udot);

  const course at(b, udot);
  const auto where = [&](const jet(&q)[3]) {
    const jet3x3 turn = limits::rotation(jet3(0, 0, 1), q[0]) * limits::rotation(jet3(1, 0, 0), q[1]);
    return turn * jet3(0, 0.3, q[2]);
  };
  const jet m = 4 - at.t * (0.2 + sin(at.q[1])) + at.q[2] * at.q[2];
  const jet3 momentum = m * where(at.q).rate();
  const Vector3d missing = momentum.rate().value() - force;
  for (int r = 0; r < 3; ++r) {
    jet q[3]{b.q_now[0], b.q_now[1], b.q_now[2]};
    q[r].c1 = 1;
    const Vector3d partial = where(q).rate().value();
    EXPECT_NEAR(partial.dot(missing) + udot(r), 0, 1e-13) << r; // the ballast has speed r and mass 1
  }
}

// A top that grows, with its inertia about a point other than its mass center: the torque is dH/dt about the
// fixed point.
TEST(inertia, obeys_the_law_of_angular_momentum) {
  for (const bool about_pivot : {false, true}) {
    SCOPED_TRACE(about_pivot);
    bench b;
    const frame_id f = b.body_fixed("F", b.n, "zxz", b.q[0], b.q[1], b.q[2]);
    const double arm = 0.7;
    const point_id center = b.offset("G", b.o, b.along(f, 0, 0, arm));
    const expression zero = b.number(0.0), mass = b.number(1.5) + b.time(),
                     across = b.number(2) + b.time() * b.q[2], along = b.number(0.6) + sin(b.q[1]) / 5,
                     product = b.time() / 10;
    b.rigid_body("Top", center, f, mass, b.inertia(f, across, across, along, product, zero, zero),
                 about_pivot ? b.o : center);
    const Vector3d torque(0.4, -0.2, 0.9);
    b.torque(f, b.along(b.n, torque(0), torque(1), torque(2)));
    ASSERT_EQ(b.check().view(), "");
    mechanics::equations e(b.system());
    const VectorXd udot = found(b, e, quantity::udot);

    const auto turned = [&](const jet(&q)[3]) {
      return limits::rotation(jet3(0, 0, 1), q[0]) * limits::rotation(jet3(1, 0, 0), q[1]) *
             limits::rotation(jet3(0, 0, 1), q[2]);
    };
    const auto angular_velocity = [&](const jet(&q)[3]) {
      jet3 twice;
      for (const jet3& basis : turned(q).column) twice = twice + cross(basis, basis.rate());
      return jet(0.5) * twice;
    };
    const course at(b, udot);
    const jet m = 1.5 + at.t;
    const jet3x3 axes = turned(at.q);
    const jet3 omega = angular_velocity(at.q);
    const jet own[3]{dot(axes.column[0], omega), dot(axes.column[1], omega), dot(axes.column[2], omega)};
    const jet i = 2 + at.t * at.q[2], k = 0.6 + sin(at.q[1]) / 5, p = at.t / 10;
    jet3 h = axes * jet3(i * own[0] + p * own[1], p * own[0] + i * own[1], k * own[2]);
    const jet3 reach = jet(arm) * axes.column[2];
    if (!about_pivot) h = h + m * cross(reach, reach.rate());
    const Vector3d missing = h.rate().value() - torque;
    for (int r = 0; r < 3; ++r) {
      jet q[3]{b.q_now[0], b.q_now[1], b.q_now[2]};
      q[r].c1 = 1;
      EXPECT_NEAR(angular_velocity(q).value().dot(missing) + udot(r), 0, 1e-13) << r;
    }
  }
}

// A prescribed quantity also has a rate.
TEST(mass, may_be_prescribed) {
  bench b;
  const expression mass = b.prescribed("m");
  const point_id p = b.offset("P", b.o, b.along(b.n, b.q[0], b.number(0.0), b.number(0.0)));
  b.particle("Tank", p, mass);
  ASSERT_EQ(b.check().view(), "");
  b.r_now = {3, 0.8, 100};
  mechanics::equations e(b.system());
  expect_equal(found(b, e, quantity::udot), Vector3d(-0.8 * b.u_now[0] / (3 + 1), 0, 0));
}

// A wheel that is not axisymmetric, described in axes that do not spin with it: its inertia is constant in
// these axes.
TEST(inertia, changes_where_its_axes_turn_in_the_body) {
  bench b;
  const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const frame_id a = b.rotated("A", yaw, b.q[2], b.along(yaw, 1, 0, 0));
  const frame_id wheel = b.rotated("W", a, b.q[1], b.along(a, 0, 1, 0));
  const Vector3d principal(0.5, 0.8, 1.1);
  b.rigid_body("Wheel", b.o, wheel, b.number(1),
               b.inertia(a, b.number(principal(0)), b.number(principal(1)), b.number(principal(2))));
  EXPECT_EQ(b.check().view(), "the inertia of Wheel is given along the axes of A and changes as seen from W, "
                              "the body frame; if this is intended, write changing_inertia<...>");
  b.changing_inertia("Wheel");
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  const VectorXd udot = found(b, e, quantity::udot);

  // in A's axes
  const double* u = b.u_now;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const Vector3d up(0, std::sin(b.q_now[2]), std::cos(b.q_now[2])), up_rate = u[2] * up.cross(x);
  const Vector3d omega = u[0] * up + u[1] * y + u[2] * x;
  const Vector3d change = udot(0) * up + u[0] * up_rate + udot(1) * y + udot(2) * x;
  const Vector3d h = principal.cwiseProduct(omega);
  const Vector3d rate = principal.cwiseProduct(change) + (omega - u[1] * y).cross(h);
  expect_equal(Vector3d(up.dot(rate), y.dot(rate), x.dot(rate)), -udot); // the ballast takes it
}

// ---- motion that is prescribed

// A pendulum whose pivot moves as prescribed, up and sideways.
TEST(prescribed, moves_the_pivot_of_a_pendulum) {
  bench b(false);
  for (int i = 0; i < 3; ++i) b.kinematic_equation(b.dot(b.q[i]) - b.u[i]);
  const expression aside = b.prescribed("x"), up = b.prescribed("y"), zero = b.number(0.0);
  const frame_id rod = b.rotated("Rod", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const double length = 1.3;
  const point_id pivot = b.offset("Pivot", b.o, b.along(b.n, aside, up, zero)),
                 bob = b.offset("P", pivot, b.along(rod, 0, -length, 0));
  b.particle("Bob", bob, b.number(0.8));
  b.particle("Elsewhere", b.offset("B", b.o, b.along(b.n, zero, b.q[1], b.q[2])), b.number(1));
  b.gravity(b.along(b.n, 0, -9.81, 0));
  ASSERT_EQ(b.check().view(), "");
  b.r_now = {0.4, -0.3, 1.7, -0.2, 0.6, -2.1};
  mechanics::equations e(b.system());
  const double s = std::sin(b.q_now[0]), c = std::cos(b.q_now[0]), w = b.u_now[0];
  const double alpha = -((9.81 + b.r_now[5]) * s + b.r_now[2] * c) / length;
  expect_equal(found(b, e, quantity::udot).head(1), VectorXd::Constant(1, alpha));
  expect_equal(b.in_ground(mechanics::velocity_of_point(e.moving(), place(bob))),
               Vector3d(b.r_now[1] + length * w * c, b.r_now[4] + length * w * s, 0));
}

// A bead in a tube that rotates as prescribed; an auxiliary speed across the tube brings into evidence the
// force that holds the bead in it, m (q θ̈ + 2 q̇ θ̇ + g cos θ).
TEST(prescribed, turns_a_tube) {
  bench b(false);
  for (int i = 0; i < 3; ++i) b.kinematic_equation(b.dot(b.q[i]) - b.u[i]);
  const expression angle = b.prescribed("theta"), zero = b.number(0.0);
  const frame_id tube = b.rotated("Tube", b.n, angle, b.along(b.n, 0, 0, 1));
  const point_id bead = b.offset("P", b.o, b.along(tube, b.q[0], zero, zero));
  b.velocity(bead, tube, b.along(tube, b.u[0], b.auxiliary_speed("across"), zero));
  const double mass = 0.8;
  b.particle("Bead", bead, b.number(mass));
  b.particle("Elsewhere", b.offset("B", b.o, b.along(b.n, zero, b.q[1], b.q[2])), b.number(1));
  b.gravity(b.along(b.n, 0, -9.81, 0));
  ASSERT_EQ(b.check().view(), "");
  b.r_now = {0.4, -1.3, 1.7};
  mechanics::equations e(b.system());
  const double q = b.q_now[0], u = b.u_now[0], rate = b.r_now[1];
  expect_equal(found(b, e, quantity::udot).head(1),
               VectorXd::Constant(1, q * rate * rate - 9.81 * std::sin(b.r_now[0])));
  expect_equal(found(b, e, quantity::noncontributing_forces),
               VectorXd::Constant(1, mass * (q * b.r_now[2] + 2 * u * rate + 9.81 * std::cos(b.r_now[0]))));
}

} // namespace
