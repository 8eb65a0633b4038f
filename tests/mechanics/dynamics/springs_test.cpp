// builds: clang++
// The effects of springs, dampers and potential energies on motion, energy and constraint forces.
#include "mechanics/workbench.hpp"

#include <kanexpr/mechanics/skeleton/time_derivative.hpp>

#include <random>

namespace {

using namespace workbench;

VectorXd found(bench& b, mechanics::equations& e, quantity q) { return b.numbers(e.get(q)); }

// Two bars in space on rotating joints, with a sliding bob.
struct arm : bench {
  frame_id first, second;
  point_id elbow, tip, wall, bob;

  arm() {
    first = rotated("A", n, q[0], along(n, 0, 0, 1));
    second = rotated("B", first, q[1], along(first, 1, 0, 0));
    wall = offset("W", o, along(n, -0.4, 0.7, 1.3));
    elbow = offset("E", o, along(first, 0.8, 0.1, 0));
    tip = offset("T", elbow, along(second, 0.2, 0.9, -0.3));
    bob = offset("S", o, along(n, number(0.3), q[2], number(-0.9)));
    rigid_body("First", elbow, first, number(1.3), inertia(first, number(0.2), number(0.3), number(0.4)));
    rigid_body("Second", tip, second, number(0.7), inertia(second, number(0.1), number(0.2), number(0.3)));
    particle("Bob", bob, number(0.5));
    gravity(along(n, 0, -9.81, 0));
  }

  Vector3d position(point_id p) { return in_ground(mechanics::position_from_origin(mechanism(), place(p))); }
  void shuffle(std::mt19937& random) {
    std::uniform_real_distribution<double> values(-1.5, 1.5);
    for (int i = 0; i < 3; ++i) q_now[i] = values(random), u_now[i] = values(random);
  }
};

TEST(springs, pull_as_force_vectors_do) {
  std::mt19937 random(11);
  for (int state = 0; state < 5; ++state) {
    arm sprung, pulled;
    sprung.shuffle(random);
    for (int i = 0; i < 3; ++i) pulled.q_now[i] = sprung.q_now[i], pulled.u_now[i] = sprung.u_now[i];
    sprung.spring(sprung.tip, sprung.wall, sprung.number(3));
    sprung.spring(sprung.bob, sprung.tip, sprung.number(5), sprung.number(0.6));
    const auto pull = [&](point_id a, point_id b, double stiffness, double length) {
      const Vector3d line = pulled.position(a) - pulled.position(b);
      const Vector3d force = -stiffness * (line.norm() - length) * line.normalized();
      pulled.force(a, pulled.along(pulled.n, force.x(), force.y(), force.z()));
      pulled.force(b, pulled.along(pulled.n, -force.x(), -force.y(), -force.z()));
      return stiffness * std::pow(line.norm() - length, 2) / 2;
    };
    const double energy = pull(pulled.tip, pulled.wall, 3, 0) + pull(pulled.bob, pulled.tip, 5, 0.6);
    ASSERT_EQ(sprung.check().view(), "");
    mechanics::equations s(sprung.system()), p(pulled.system());
    for (quantity q : {quantity::udot, quantity::forcing, quantity::active_forces})
      expect_equal(found(sprung, s, q), found(pulled, p, q));
    const double by_gravity = found(pulled, p, quantity::potential_energy)(0);
    EXPECT_NEAR(found(sprung, s, quantity::potential_energy)(0), by_gravity + energy, 1e-12 * energy);
  }
}

// Ė along a motion is the power of the dampers.
TEST(springs, keep_what_dampers_do_not_take) {
  std::mt19937 random(12);
  for (const bool damped : {false, true}) {
    arm a;
    a.spring(a.tip, a.wall, a.number(3), a.number(0.5));
    a.spring(a.bob, a.elbow, a.number(5));
    a.torsional_spring(a.q[1] - a.q[0] / 2, a.number(4), a.number(0.3));
    a.potential_energy(sin(a.q[0]) * a.q[2] + exp(a.q[1] * a.q[2]));
    const double along_line = 0.8, beside = 0.4, joint = 0.6, outer = 0.2;
    if (damped) {
      a.damper(a.wall, a.tip, a.number(along_line)); // next to the spring
      a.damper(a.bob, a.tip, a.number(beside));
      a.torsional_damper(a.second, a.first, a.number(joint));
      a.torsional_damper(a.second, a.n, a.number(outer));
    }
    ASSERT_EQ(a.check().view(), "");
    mechanics::equations e(a.system());
    mechanics::sequence<expression> udot;
    const kanexpr::symbolic::matrix rates = e.get(quantity::udot);
    for (const expression& rate : rates.entries) udot.push(rate);
    kanexpr::symbolic::differentiation along_time =
        mechanics::time_derivative(a.mechanism(), e.skeleton_used().coordinate_rates, udot);
    kanexpr::symbolic::matrix energy(a.graph(), 1, 1);
    energy.entries[0] = along_time.of(e.get(quantity::kinetic_energy).entries[0] +
                                      e.get(quantity::potential_energy).entries[0]);
    for (int state = 0; state < 20; ++state) {
      a.shuffle(random);
      const auto moving = [&](point_id p, point_id other) { // rate of the distance
        const Vector3d line = a.position(p) - a.position(other);
        return line.normalized().dot(a.in_ground(mechanics::velocity_of_point(e.moving(), place(p)) -
                                                 mechanics::velocity_of_point(e.moving(), place(other))));
      };
      const auto turning = [&](frame_id f) {
        return a.in_ground(mechanics::angular_velocity_of_frame(e.moving(), place(f)));
      };
      const double power = -along_line * std::pow(moving(a.tip, a.wall), 2) -
                           beside * std::pow(moving(a.bob, a.tip), 2) -
                           joint * (turning(a.second) - turning(a.first)).squaredNorm() -
                           outer * turning(a.second).squaredNorm();
      const double scale =
          1 + (found(a, e, quantity::active_forces).array() * Vector3d(a.u_now).array()).abs().sum();
      EXPECT_NEAR(a.numbers(energy)(0), damped ? power : 0, 1e-12 * scale);
    }
  }
}

// −Σ ∂V/∂q W for speeds that are not coordinate rates.
TEST(springs, act_on_quasi_speeds_by_the_kinematic_equations) {
  bench b(false);
  Matrix3d w;
  w << 1, 0.4, 0, 0.3, -2, 0.5, 0, 0.7, 1.5;
  for (int i = 0; i < 3; ++i) {
    expression rate = b.number(0.2 * i);
    for (int j = 0; j < 3; ++j) rate += b.number(w(i, j)) * b.u[j];
    b.kinematic_equation(b.dot(b.q[i]) - rate);
  }
  b.particle("P", b.offset("P", b.o, b.along(b.n, b.q[0], b.q[1], b.q[2])), b.number(2));
  b.potential_energy(b.q[0] * b.q[0] * b.q[1] + b.time() * cos(b.q[2]));
  b.potential_energy(3 * b.q[1] / b.q[2]);
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  const double x = b.q_now[0], y = b.q_now[1], z = b.q_now[2], t = b.t_now;
  const Vector3d gradient(2 * x * y, x * x + 3 / z, -t * std::sin(z) - 3 * y / (z * z));
  expect_equal(found(b, e, quantity::active_forces), -w.transpose() * gradient);
  expect_equal(found(b, e, quantity::potential_energy),
               VectorXd::Constant(1, x * x * y + t * std::cos(z) + 3 * y / z));
}

// A spring and a damper contribute to an auxiliary speed like any other force, although no coordinate belongs
// to it.
TEST(springs, act_on_auxiliary_speeds) {
  MatrixXd force[2];
  for (const bool by_vectors : {false, true}) {
    bench b;
    const expression lift = b.auxiliary_speed("lift"), zero = b.number(0.0);
    const point_id p = b.offset("P", b.o, b.along(b.n, b.q[0], b.q[1], zero));
    b.velocity(p, b.n, b.along(b.n, b.u[0], b.u[1], lift));
    const point_id wall = b.offset("W", b.o, b.along(b.n, 0.2, 1.4, 0.8));
    b.particle("Bead", p, b.number(1.5));
    if (by_vectors) {
      const Vector3d line(b.q_now[0] - 0.2, b.q_now[1] - 1.4, -0.8), v(b.u_now[0], b.u_now[1], 0);
      const Vector3d f = -(2 * (line.norm() - 0.3) + 0.7 * v.dot(line) / line.norm()) * line.normalized();
      b.force(p, b.along(b.n, f.x(), f.y(), f.z()));
    } else {
      b.spring(wall, p, b.number(2), b.number(0.3));
      b.damper(p, wall, b.number(0.7));
    }
    ASSERT_EQ(b.check().view(), "");
    mechanics::equations e(b.system());
    force[by_vectors] = found(b, e, quantity::noncontributing_forces);
  }
  EXPECT_GT(std::abs(force[1](0)), 0.1);
  expect_equal(force[0], force[1]);
}

// A load may contain velocities that were formed before a result is requested.
TEST(loads, of_motion_are_built_when_velocities_are_known) {
  arm dragged, pulled;
  mechanics::known_motion known(dragged.mechanism());
  const vector v = mechanics::velocity_of_point(known.moving(), place(dragged.tip));
  dragged.force(dragged.tip, dragged.number(-0.7) * v);
  const Vector3d drag = -0.7 * dragged.in_ground(v);
  pulled.force(pulled.tip, pulled.along(pulled.n, drag.x(), drag.y(), drag.z()));
  ASSERT_EQ(dragged.check().view(), "");
  mechanics::equations d(dragged.system()), p(pulled.system());
  for (quantity q : {quantity::udot, quantity::active_forces})
    expect_equal(found(dragged, d, q), found(pulled, p, q));
}

std::string mistake(void (*make)(arm&)) {
  arm a;
  make(a);
  return std::string(a.check().view());
}

TEST(springs, are_looked_at) {
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.tip, a.tip, a.number(1)); }),
            "a spring acts between point T and itself");
  EXPECT_EQ(mistake([](arm& a) { a.damper(a.tip, a.tip, a.number(1)); }),
            "a damper acts between point T and itself");
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.o, a.offset("Z", a.o, a.along(a.n, 0.0, 0, 0)), a.number(1)); }),
            "the spring between O and Z has zero length in every configuration");
  EXPECT_EQ(
      mistake([](arm& a) { a.damper(a.tip, a.origin("M"), a.number(1)); }),
      "the damper between T and M has ends measured from two origins, O and M, whose distance is not known");
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.tip, a.o, a.q[0]); }),
            "the stiffness of the spring between T and O contains the coordinate q0; it may contain only "
            "parameters, inputs and time");
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.tip, a.o, a.number(1), a.u[0]); }),
            "the natural length of the spring between T and O contains the speed u0; it may contain only "
            "parameters, inputs and time");
  EXPECT_EQ(mistake([](arm& a) { a.damper(a.tip, a.o, a.dot(a.u[1])); }),
            "the damping between T and O contains the rate of speed u1");
  EXPECT_EQ(mistake([](arm& a) { a.potential_energy(a.q[0]), a.potential_energy(a.q[0] * a.u[2]); }),
            "potential energy 2 contains the speed u2; it may contain only coordinates");
  EXPECT_EQ(mistake([](arm& a) { a.potential_energy(a.dot(a.q[0])); }),
            "potential energy 1 contains the rate of coordinate q0; it may contain only coordinates");
  EXPECT_EQ(mistake([](arm& a) { a.torsional_damper(a.first, a.first, a.number(1)); }),
            "a torsional damper acts between frame A and itself");
  EXPECT_EQ(mistake([](arm& a) { a.torque_between(a.first, a.first, a.along(a.n, 0, 0, 1)); }),
            "a torque acts between frame A and itself");
  EXPECT_EQ(mistake([](arm& a) { a.force_between(a.tip, a.tip, a.along(a.n, 0, 0, 1)); }),
            "a force acts between point T and itself");
  EXPECT_EQ(mistake([](arm& a) { a.force_between(a.tip, a.o, a.dot(a.u[0]) * a.along(a.n, 0, 0, 1)); }),
            "the force between T and O contains the rate of speed u0");
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.tip, point_id{99}, a.number(1)); }),
            "a spring refers to point number 99, which does not exist");
  EXPECT_EQ(mistake([](arm& a) { a.spring(a.tip, a.o, a.number(-2)), a.damper(a.tip, a.o, a.number(-1)); }),
            "");
}

} // namespace
