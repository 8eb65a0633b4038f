// builds: clang++
// All ways to describe frames, points and inertias, compared with plain numbers.
#include "mechanics/workbench.hpp"

#include <Eigen/Geometry>

namespace {

using namespace workbench;

// The rotation of a frame in numbers: matrix and angular velocity in the ground.
struct turning {
  Matrix3d r = Matrix3d::Identity();
  Vector3d omega = Vector3d::Zero();
};

TEST(sequences, are_products_of_turns) {
  constexpr const char* all[]{"xyz", "yzx", "zxy", "xzy", "zyx", "yxz",
                              "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};
  for (const char* letters : all)
    for (const bool space : {false, true}) {
      SCOPED_TRACE(std::string(letters) + (space ? " space-fixed" : " body-fixed"));
      bench b;
      const frame_id f = space ? b.space_fixed("F", b.n, letters, b.q[0], b.q[1], b.q[2])
                               : b.body_fixed("F", b.n, letters, b.q[0], b.q[1], b.q[2]);
      ASSERT_EQ(b.check().view(), "");
      turning expected;
      for (int i = 0; i < 3; ++i) {
        const Vector3d axis = Vector3d::Unit(letters[i] - 'x');
        const Matrix3d one = Eigen::AngleAxisd(b.q_now[i], axis).toRotationMatrix();
        if (space) { // each rotation is about an axis of the ground and carries along everything that was
                     // rotated before
          expected.omega = one * expected.omega + b.u_now[i] * axis;
          expected.r = one * expected.r;
        } else {
          expected.omega += b.u_now[i] * (expected.r * axis);
          expected.r = expected.r * one;
        }
      }
      mechanics::equations derived(b.system());
      expect_equal(b.to_ground(f), expected.r);
      expect_equal(b.in_ground(mechanics::angular_velocity_of_frame(derived.moving(), place(f))),
                   expected.omega);
    }
}

// A declared motion states what the derivation finds; from there on, all results are the same.
TEST(declared_angular_velocity, stands_for_the_derived_one_in_any_reference) {
  const auto build = [](bench& b, int reference) {
    const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
    const frame_id c = b.rotated("C", a, b.q[1], b.along(a, 1, 0, 0));
    const frame_id d = b.rotated("D", c, b.q[2], b.along(c, 0, 1, 0)),
                   side = b.rotated("S", a, b.q[2], b.along(a, 1, 0, 0));
    const expression zero = b.number(0.0);
    const vector yaw = b.along(b.n, zero, zero, b.u[0]), roll = b.along(c, b.u[1], zero, zero);
    const vector spin = b.along(d, zero, b.u[2], zero);
    if (reference == 0) b.angular_velocity(d, b.n, yaw + roll + spin);
    if (reference == 1) b.angular_velocity(d, a, roll + spin);
    if (reference == 2) b.angular_velocity(d, c, spin);
    if (reference == 3) b.angular_velocity(d, side, roll + spin - b.along(a, b.u[2], zero, zero));
    const point_id p = b.offset("P", b.o, b.along(d, 0.3, -0.4, 0.5) + b.along(c, 0.1, 0.7, 0));
    b.rigid_body("Body", p, d, b.number(2), b.inertia(d, b.number(1), b.number(1.5), b.number(0.7)));
    ASSERT_EQ(b.check().view(), "");
  };
  bench plain;
  build(plain, -1);
  mechanics::equations expected(plain.system());
  for (const int reference : {0, 1, 2, 3}) {
    SCOPED_TRACE(reference);
    bench b;
    build(b, reference);
    mechanics::equations found(b.system());
    for (const quantity q : {quantity::mass_matrix, quantity::forcing, quantity::udot,
                             quantity::kinetic_energy, quantity::angular_momentum, quantity::inertia_forces})
      expect_equal(b.numbers(found.get(q)), plain.numbers(expected.get(q)));
  }
}

// v = v_O + ω×r + the declared velocity, a = a_O + α×r + ω×(ω×r) + 2ω×v' + v'', with P sliding in a rotating
// frame.
TEST(one_point_theorem, adds_the_velocity_in_a_turning_frame) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  const frame_id c = b.rotated("C", a, b.q[1], b.along(a, 1, 0, 0));
  const expression zero = b.number(0.0);
  // along C's y axis by q2; as seen from A, a translation and a rotation about A's x axis
  const auto at = [&](const char* name) {
    return b.offset(name, b.o, b.along(c, zero, b.q[2], b.number(0.2)));
  };
  const point_id derived_point = at("P0"), in_c = at("P1"), in_a = at("P2"), in_n = at("P3");
  const vector slide = b.along(c, zero, b.u[2], zero);
  const vector seen_from_a = slide + b.along(c, zero, b.number(-0.2) * b.u[1], b.u[1] * b.q[2]);
  const vector by_a = b.along(a, -b.u[0] * (cos(b.q[1]) * b.q[2] - b.number(0.2) * sin(b.q[1])), zero, zero);
  b.velocity(in_c, c, slide);
  b.velocity(in_a, a, seen_from_a);
  b.velocity(in_n, b.n, seen_from_a + by_a);
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());

  const Matrix3d ra = b.to_ground(a), rc = b.to_ground(c);
  const Vector3d r = rc * Vector3d(0, b.q_now[2], 0.2), z = Vector3d::UnitZ(), x = ra.col(0);
  const Vector3d omega = b.u_now[0] * z + b.u_now[1] * x;
  const Vector3d alpha = b.udot_now[0] * z + b.udot_now[1] * x + b.u_now[0] * b.u_now[1] * z.cross(x);
  const Vector3d v = omega.cross(r) + b.u_now[2] * rc.col(1);
  const Vector3d acceleration = alpha.cross(r) + omega.cross(omega.cross(r)) +
                                2 * b.u_now[2] * omega.cross(rc.col(1)) + b.udot_now[2] * rc.col(1);
  for (const point_id p : {derived_point, in_c, in_a, in_n}) {
    SCOPED_TRACE(place(p));
    expect_equal(b.in_ground(mechanics::velocity_of_point(e.moving(), place(p))), v);
    expect_equal(b.in_ground(mechanics::acceleration_of_point(e.moving(), place(p))), acceleration);
  }
}

// Kane's rolling disc: the contact point, and the mass center fixed in the disc, with the offset in axes that
// do not spin. A zero velocity in the disc is then intentionally inconsistent with the position.
TEST(two_point_theorem, takes_an_offset_in_the_axes_of_another_frame) {
  for (const bool is_apart : {false, true}) {
    SCOPED_TRACE(is_apart);
    bench b(false);
    const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1));
    const frame_id lean = b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0));
    const frame_id disc = b.rotated("R", lean, b.q[2], b.along(lean, 0, 1, 0));
    b.angular_velocity(disc, b.n, b.along(lean, b.u[0], b.u[1], b.u[2]));
    const double mass = 2, radius = 0.6, across = 0.18, along = 0.36;
    const point_id center = b.offset("Dmc", b.o, b.along(lean, 0, 0, radius));
    if (is_apart)
      b.velocity_apart_from_position(center, disc, vector());
    else
      b.fixed_in(center, disc);
    b.rigid_body("Disc", center, disc, b.number(mass),
                 b.inertia(lean, b.number(across), b.number(along), b.number(across)));
    b.force(center, b.along(yaw, 0, 0, -9.81 * mass));
    b.kinematic_equation(b.dot(b.q[0]) - b.u[2] / cos(b.q[1]));
    b.kinematic_equation(b.dot(b.q[1]) - b.u[0]);
    b.kinematic_equation(b.dot(b.q[2]) - b.u[1] + b.u[2] * tan(b.q[1]));
    ASSERT_EQ(b.check().view(), "");
    mechanics::equations e(b.system());

    // in L's axes: ω = u, v = ω×r z, and every rate of a vector is its rate in L plus ω_L×
    const Vector3d u = Vector3d::Map(b.u_now), udot = Vector3d::Map(b.udot_now),
                   arm = radius * Vector3d::UnitZ();
    const Vector3d omega_l(u(0), u(2) * std::tan(b.q_now[1]), u(2));
    const Matrix3d inertia = Vector3d(across, along, across).asDiagonal();
    Matrix3d partial_velocity, mass_matrix;
    for (int i = 0; i < 3; ++i) partial_velocity.col(i) = Vector3d::Unit(i).cross(arm);
    mass_matrix = mass * partial_velocity.transpose() * partial_velocity + inertia;
    const Vector3d v = u.cross(arm), bias = omega_l.cross(v), alpha_bias = omega_l.cross(u);
    const Vector3d inertia_bias =
        -partial_velocity.transpose() * (mass * bias) - inertia * alpha_bias - u.cross(inertia * u);
    const Vector3d weight = Eigen::AngleAxisd(-b.q_now[1], Vector3d::UnitX()) * Vector3d(0, 0, -9.81 * mass);
    const Vector3d active = partial_velocity.transpose() * weight;
    expect_equal(b.in_axes(lean, mechanics::velocity_of_point(e.moving(), place(center))), v);
    expect_equal(b.in_axes(lean, mechanics::acceleration_of_point(e.moving(), place(center))),
                 udot.cross(arm) + bias);
    expect_equal(b.numbers(e.get(quantity::mass_matrix)), mass_matrix);
    expect_equal(b.numbers(e.get(quantity::active_forces)), active);
    expect_equal(b.numbers(e.get(quantity::inertia_forces)), inertia_bias - mass_matrix * udot);
    expect_equal(b.numbers(e.get(quantity::forcing)), active + inertia_bias);
  }
}

TEST(inertia, may_be_about_another_point_and_a_sum_over_frames) {
  const auto build = [](bench& b, bool plain) {
    const frame_id f = b.body_fixed("F", b.n, "xyz", b.q[0], b.q[1], b.q[2]);
    const frame_id g = b.rotated("G", f, b.number(0.7), b.along(f, 1, 2, -2));
    const point_id c = b.offset("C", b.o, b.along(f, 0.2, -0.5, 0.4)),
                   p = b.offset("P", c, b.along(g, 0.6, 0, -0.3));
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -2).normalized()).toRotationMatrix();
    Matrix3d in_f, in_g;
    in_f << 1.2, 0.1, -0.2, 0.1, 0.9, 0.05, -0.2, 0.05, 1.4;
    in_g << 0.8, -0.1, 0.1, -0.1, 1.1, 0.2, 0.1, 0.2, 0.7;
    const auto scalars = [&](frame_id axes, const Matrix3d& i) {
      return b.inertia(axes, b.number(i(0, 0)), b.number(i(1, 1)), b.number(i(2, 2)), b.number(i(0, 1)),
                       b.number(i(1, 2)), b.number(i(2, 0)));
    };
    if (!plain) return b.rigid_body("Body", c, f, b.number(1), scalars(f, in_f) + scalars(g, in_g), p);
    const Vector3d r = turn * Vector3d(0.6, 0, -0.3);
    const Matrix3d central =
        in_f + turn * in_g * turn.transpose() - (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    b.rigid_body("Body", c, f, b.number(1), scalars(f, central));
  };
  bench plain, given;
  build(plain, true), build(given, false);
  ASSERT_EQ(plain.check().view(), "");
  ASSERT_EQ(given.check().view(), "");
  mechanics::equations expected(plain.system()), found(given.system());
  for (const quantity q : {quantity::mass_matrix, quantity::forcing, quantity::kinetic_energy,
                           quantity::angular_momentum, quantity::linear_momentum})
    expect_equal(given.numbers(found.get(q)), plain.numbers(expected.get(q)));
}

// F_r with unit loads is a partial velocity: v_r·e and ω_r·e.
TEST(partial_velocities, are_what_unit_loads_do) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool turn : {false, true}) {
      bench b;
      const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
      const frame_id c = b.rotated("C", a, b.q[1], b.along(a, 1, 1, 0));
      const point_id p = b.offset("P", b.o, b.along(c, b.q[2], b.number(0.3), b.number(1)));
      const vector unit = b.along(b.n, axis == 0, axis == 1, axis == 2);
      turn ? b.torque(c, unit) : b.force(p, unit);
      mechanics::equations e(b.system());
      const Matrix3d rc = b.to_ground(c);
      const Vector3d r = rc * Vector3d(b.q_now[2], 0.3, 1);
      Matrix3d angular = Matrix3d::Zero(), linear;
      angular.col(0) = Vector3d::UnitZ();
      angular.col(1) = b.to_ground(a) * Vector3d(1, 1, 0).normalized();
      for (int i = 0; i < 3; ++i) linear.col(i) = angular.col(i).cross(r);
      linear.col(2) += rc.col(0);
      const Matrix3d& partial = turn ? angular : linear;
      expect_equal(b.numbers(e.get(quantity::active_forces)), partial.row(axis).transpose());
    }
}

} // namespace
