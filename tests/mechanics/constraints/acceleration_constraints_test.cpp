// builds: clang++
// Constraints that are given in addition to, or in place of, those that the library would derive.
#include "mechanics/workbench.hpp"

namespace {

using namespace workbench;

// Three beads on wires; the first two are coupled by a lever whose ratio changes, and by a motor.
struct beads : bench {
  expression ratio, drift;
  beads() {
    ratio = number(2) + sin(q[0]) * q[2];
    drift = sin(time());
    for (int i = 0; i < 3; ++i) {
      const expression x = i == 0 ? q[i] : number(0.0), y = i == 1 ? q[i] : number(0.0),
                       z = i == 2 ? q[i] : number(0.0);
      const point_id at = offset("P" + std::to_string(i), o, along(n, x, y, z));
      particle("Bead" + std::to_string(i), at, number(1 + i));
      force(at, along(n, 1, -2, 0.5));
    }
  }
  void bind() { velocity_constraint(u[1] - ratio * u[0] - drift); }
  // its rate, by hand: u̇1 − ratio u̇0 − (cos q0 u0 q2 + sin q0 u2) u0 − cos t
  expression rate() {
    return dot(u[1]) - ratio * dot(u[0]) - (cos(q[0]) * u[0] * q[2] + sin(q[0]) * u[2]) * u[0] - cos(time());
  }
};

MatrixXd found(beads& b, quantity q) {
  EXPECT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  e.constrain();
  EXPECT_EQ(e.mistake().view(), "");
  return b.numbers(e.get(q));
}

TEST(acceleration_constraints, may_repeat_what_is_derived) {
  for (const quantity q :
       {quantity::udot, quantity::multipliers, quantity::acceleration_bias, quantity::forcing}) {
    beads derived, given, scaled;
    derived.bind(), given.bind(), scaled.bind();
    given.acceleration_constraint(given.rate());
    scaled.acceleration_constraint((scaled.number(3) + cos(scaled.q[1])) * scaled.rate());
    const MatrixXd expected = found(derived, q);
    expect_equal(found(given, q), expected);
    expect_equal(found(scaled, q), expected);
  }
}

TEST(acceleration_constraints, take_the_place_of_what_is_derived) {
  beads b;
  b.bind();
  const expression slip = b.u[1] - b.ratio * b.u[0] - b.drift;
  b.acceleration_constraint(b.rate() + 5 * slip); // as in Baumgarte's method, so that a slip decays
  const VectorXd udot = found(b, quantity::udot);
  const double q0 = b.q_now[0], q2 = b.q_now[2], u0 = b.u_now[0], u1 = b.u_now[1], u2 = b.u_now[2];
  const double ratio = 2 + std::sin(q0) * q2, left = u1 - ratio * u0 - std::sin(b.t_now);
  EXPECT_GT(std::abs(left), 1);
  const double rate =
      udot(1) - ratio * udot(0) - (std::cos(q0) * u0 * q2 + std::sin(q0) * u2) * u0 - std::cos(b.t_now);
  EXPECT_NEAR(rate, -5 * left, 1e-13);
}

// Two constraints, given in a different order and mixed.
TEST(acceleration_constraints, may_be_mixed) {
  beads derived, given;
  for (beads* b : {&derived, &given}) {
    b->bind();
    b->configuration_constraint(b->q[2] - sin(b->q[1]));
  }
  const expression second = given.dot(given.u[2]) - cos(given.q[1]) * given.dot(given.u[1]) +
                            sin(given.q[1]) * given.u[1] * given.u[1];
  given.acceleration_constraint(given.rate() + second);
  given.acceleration_constraint(given.rate() - 2 * second);
  for (const quantity q : {quantity::udot, quantity::multipliers, quantity::forcing})
    expect_equal(found(given, q), found(derived, q));
}

// Many users write both a configuration constraint and its rate.
TEST(configuration_constraints, may_have_their_rates_among_the_velocity_constraints) {
  for (const bool twice : {false, true}) {
    SCOPED_TRACE(twice);
    beads once, repeated;
    for (beads* b : {&once, &repeated}) {
      if (b == &repeated) {
        b->velocity_constraint(2 * b->u[2] - 2 * cos(b->q[1]) * b->u[1]);
        if (twice) b->velocity_constraint(b->dot(b->q[0]) - b->u[1]);
      }
      b->configuration_constraint(b->q[2] - sin(b->q[1]));
      if (twice) b->configuration_constraint(b->q[0] - b->q[1]);
    }
    expect_equal(found(repeated, quantity::udot), found(once, quantity::udot));
    EXPECT_EQ(found(repeated, quantity::velocity_residual).rows(), twice ? 2 : 1);
    EXPECT_EQ(found(repeated, quantity::configuration_residual).rows(), twice ? 2 : 1);
  }
}

std::string told(bench& b) {
  EXPECT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  e.constrain();
  return std::string(e.mistake().view());
}

// The remainder of an acceleration constraint may be anything that vanishes wherever the constraints hold.
TEST(acceleration_constraints, are_the_rates_of_the_constraints_where_these_hold) {
  const auto with = [](auto say) {
    beads b;
    b.bind();
    b.configuration_constraint(b.q[2] - sin(b.q[1]));
    say(b, b.q[2] - sin(b.q[1]), b.u[2] - cos(b.q[1]) * b.u[1], b.dot(b.u[2]) - cos(b.q[1]) * b.dot(b.u[1]));
    return told(b);
  };
  const auto bias = [](beads& b) { return sin(b.q[1]) * b.u[1] * b.u[1]; };
  EXPECT_EQ(with([&](beads& b, expression f, expression slip, expression second) {
              b.acceleration_constraint(b.rate() + f * b.u[0]);
              b.acceleration_constraint(second + bias(b) + 6 * slip + 9 * f);
            }),
            "");
  const std::string differs = " is not the time derivative of the constraints on the velocities: the terms "
                              "without rates of speeds differ";
  EXPECT_EQ(with([&](beads& b, expression, expression, expression second) {
              b.acceleration_constraint(b.rate());
              b.acceleration_constraint(second);
            }),
            "acceleration constraint 2" + differs);
  EXPECT_EQ(with([&](beads& b, expression, expression, expression second) {
              b.acceleration_constraint(b.rate() + cos(b.time())); // half of it is missing
              b.acceleration_constraint(second + bias(b));
            }),
            "acceleration constraint 1" + differs);
}

// A velocity constraint that restricts the same speeds as the rate of a configuration constraint also
// determines the remaining terms, at least in configurations that satisfy the constraint.
TEST(velocity_constraints, do_not_contradict_the_rates_of_configurations) {
  const auto with = [](auto rest_of_rate) {
    bench b;
    const expression w = b.parameter("w"), slope = cos(b.q[0]) + 1;
    b.configuration_constraint(b.q[1] - sin(b.q[0]) - b.q[0] - w * b.time());
    b.velocity_constraint(b.u[1] - slope * b.u[0] - rest_of_rate(b, w));
    return told(b);
  };
  EXPECT_EQ(with([](bench&, expression w) { return w; }), "");
  EXPECT_EQ(
      with([](bench& b, expression w) { return w + 3 * (b.q[1] - sin(b.q[0]) - b.q[0] - w * b.time()); }),
      "");
  const std::string contradicts = "velocity constraint 1 contradicts the rate of configuration constraint 1";
  EXPECT_EQ(with([](bench&, expression w) { return -w; }), contradicts);
  EXPECT_EQ(with([](bench& b, expression) { return b.number(1); }), contradicts);
  EXPECT_EQ(with([](bench& b, expression w) { return w + b.q[0]; }), contradicts);
}

// The norm of a quaternion also holds there, whether or not it is a constraint.
TEST(velocity_constraints, may_repeat_rates_that_hold_at_unit_quaternions) {
  for (const bool is_bound : {false, true})
    for (const double factor : {1.0, 0.0}) {
      SCOPED_TRACE(is_bound);
      bench b(false);
      const expression e3 = b.coordinate("e3"), zero = b.number(0.0);
      const frame_id body = b.quaternion("F", b.n, b.q[0], b.q[1], b.q[2], e3);
      b.angular_velocity(body, b.n, b.along(body, b.u[0], b.u[1], b.u[2]));
      b.kinematics_of(body, b.n);
      const vector arm = b.along(body, 1, 2, 3), drive = b.along(b.n, zero, zero, b.time());
      const point_id p = b.offset("P", b.o, arm);
      b.rigid_body("Body", p, body, b.number(2), b.inertia(body, b.number(1), b.number(2), b.number(2.5)));
      mechanics::known_motion known(b.mechanism());
      const expression up = mechanics::express(b.mechanism(), arm, place(b.n)).z;
      const expression rises =
          mechanics::express(b.mechanism(), mechanics::velocity_of_point(known.moving(), place(p)),
                             place(b.n))
              .z;
      b.configuration_constraint(up - b.time() / 5);
      if (is_bound)
        b.configuration_constraint(b.q[0] * b.q[0] + b.q[1] * b.q[1] + b.q[2] * b.q[2] + e3 * e3 - 1);
      b.velocity_constraint(rises - b.number(factor * 0.2));
      EXPECT_EQ(told(b), factor > 0 ? ""
                                    : "velocity constraint 1 contradicts the rate of configuration "
                                      "constraint 1");
    }
}

TEST(constraints, that_contradict_those_before_them_do_not_follow_from_them) {
  const auto configuration = [](auto more) {
    bench b;
    b.configuration_constraint(b.q[1] - sin(b.q[0]));
    b.configuration_constraint(more(b, b.q[1] - sin(b.q[0])));
    return told(b);
  };
  const auto velocity = [](auto more) {
    bench b;
    b.velocity_constraint(b.u[1] - b.q[0] * b.u[0]);
    b.velocity_constraint(more(b, b.u[1] - b.q[0] * b.u[0]));
    return told(b);
  };
  const std::string follows = " follows from the preceding ones in every configuration",
                    contradicts = " contradicts the preceding ones";
  EXPECT_EQ(configuration([](bench&, expression f) { return 2 * f + f * f; }),
            "configuration constraint 2" + follows + "; add redundant<2> to drop it");
  EXPECT_EQ(configuration([](bench& b, expression f) { return f + b.parameter("l"); }),
            "configuration constraint 2" + contradicts);
  EXPECT_EQ(velocity([](bench& b, expression f) { return cos(b.q[2]) * f; }),
            "velocity constraint 2" + follows);
  EXPECT_EQ(velocity([](bench& b, expression f) { return f + b.time(); }),
            "velocity constraint 2" + contradicts);
}

// Numbers that are too small to keep their digits do not constrain anything.
TEST(constraints, are_not_lost_where_they_are_nearly_zero) {
  for (const double scale : {1e-300, 1e-310}) {
    bench b;
    b.velocity_constraint(b.number(scale) * (b.u[0] - b.u[1]));
    EXPECT_EQ(told(b),
              scale < 1e-305 ? "velocity constraint 1 constrains no speed in any configuration" : "");
  }
}

// The library chooses dependent speeds for which the constraints can be solved.
TEST(dependent_speeds, are_chosen_where_no_state_makes_them_singular) {
  bench b;
  b.velocity_constraint(sin(b.q[0]) * b.u[0] + 3 * b.u[1] + b.number(0.01) * b.u[2]);
  mechanics::equations e(b.system());
  e.constrain();
  ASSERT_EQ(e.speeds().dependent.size(), 1);
  EXPECT_EQ(e.speeds().dependent[0], 1);
}

} // namespace
