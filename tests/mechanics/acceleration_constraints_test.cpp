// Constraints that are said twice, or in place of what the library would derive.
#include "workbench.hpp"

namespace {

using namespace workbench;

// Three beads on wires; the first and the second are bound by a lever whose ratio changes, and by a motor.
struct beads : bench {
  expression ratio, drift;
  beads() {
    ratio = number(2) + sin(q[0]) * q[2];
    drift = sin(time());
    for (int i = 0; i < 3; ++i) {
      const expression x = i == 0 ? q[i] : number(0), y = i == 1 ? q[i] : number(0),
                       z = i == 2 ? q[i] : number(0);
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
  mechanics::equations e(b.mechanism());
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
  b.acceleration_constraint(b.rate() + 5 * slip); // as Baumgarte would, so that a slip dies away
  const VectorXd udot = found(b, quantity::udot);
  const double q0 = b.q_now[0], q2 = b.q_now[2], u0 = b.u_now[0], u1 = b.u_now[1], u2 = b.u_now[2];
  const double ratio = 2 + std::sin(q0) * q2, left = u1 - ratio * u0 - std::sin(b.t_now);
  EXPECT_GT(std::abs(left), 1);
  const double rate =
      udot(1) - ratio * udot(0) - (std::cos(q0) * u0 * q2 + std::sin(q0) * u2) * u0 - std::cos(b.t_now);
  EXPECT_NEAR(rate, -5 * left, 1e-13);
}

// Two at once, given in another order and mixed.
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

// Many people write a configuration constraint and its rate.
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

// The library's own dependent speeds are those that can be solved for.
TEST(dependent_speeds, are_chosen_where_no_state_makes_them_singular) {
  bench b;
  b.velocity_constraint(sin(b.q[0]) * b.u[0] + 3 * b.u[1] + b.number(0.01) * b.u[2]);
  mechanics::equations e(b.mechanism());
  e.constrain();
  ASSERT_EQ(e.speeds().dependent.size(), 1);
  EXPECT_EQ(e.speeds().dependent[0], 1);
}

} // namespace
