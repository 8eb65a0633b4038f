// builds: g++
// Mechanisms that pass positions where their constraints depend on each other, or cannot be solved for the
// dependent speeds.
#include "simulations/led_bars.hpp"
#include "steps/double_four_bar.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/simulations/model.hpp>

#include <models/pendulum_nonminimal.hpp>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace kanexpr;

constexpr double pi = std::numbers::pi;

std::vector<named_value> cranks(double q1, double q2, double q3, double u) {
  return {{"q1", q1}, {"q2", q2}, {"q3", q3}, {"b1", 0}, {"b2", 0},
          {"u1", u},  {"u2", u},  {"u3", u},  {"w1", 0}, {"w2", 0}};
}

double energy(const state<model>& x) { return double_four_bar::energy(x["q1"], x["u1"]); }

template <integrator by>
void passes_at_any_tolerance(double until = 10, double least_change = 1e-6, double of_tolerance = 1e4) {
  const model m = derive<double_four_bar::System>();
  for (const double tolerance : {1e-7, 1e-10, 1e-12}) {
    const auto run = simulate<by>(m, cranks(pi / 2, pi / 2, pi / 2, -1), {}, {0, until},
                                  {.relative_tolerance = tolerance});
    ASSERT_TRUE(run) << tolerance << ": " << run.cause();
    const double first = energy(run.trajectory[0].x);
    for (const sample<model>& s : run.trajectory) {
      ASSERT_NEAR(energy(s.x), first, (std::max)(least_change, of_tolerance * tolerance))
          << tolerance << ", t = " << s.t;
      for (const char* other : {"q2", "q3"}) // on the branch of equal cranks
        ASSERT_NEAR(s.x[other], s.x["q1"], 1e-3);
    }
    EXPECT_LT(run.state["q1"], -2 * until);
  }
}

TEST(singular_positions, are_passed_at_any_tolerance_with_constant_energy) {
  passes_at_any_tolerance<integrator::adams>();
  passes_at_any_tolerance<integrator::bdf>();
  passes_at_any_tolerance<integrator::explicit_runge_kutta>();
  passes_at_any_tolerance<integrator::implicit_runge_kutta>(2);
  passes_at_any_tolerance<integrator::differential_algebraic>(2, 1e-5, 1e5);
}

void expect_passed(const simulation<model>& run) {
  ASSERT_TRUE(run) << run.cause();
  EXPECT_NEAR(energy(run.state), energy(run.trajectory[0].x), 1e-5);
}

// All bars are aligned; the sines of multiples of π differ from zero by rounding.
TEST(singular_positions, can_be_begun_at) {
  model m = derive<double_four_bar::System>();
  for (const double other : {0.0, pi, -pi, 3 * pi}) {
    const double q = std::abs(other) > 0 ? pi : 0;
    Eigen::VectorXd x(10);
    x << q, other, q, 0, 0, -2, -2, -2, 0, 0;
    const Eigen::VectorXd given = x;
    const kanexpr::assembly placed = assemble(m, x);
    EXPECT_TRUE(placed) << placed.cause();
    EXPECT_LT((x - given).norm(), 1e-14);
    const kanexpr::consistency holds = check_consistency(m, x, Eigen::VectorXd(), Eigen::VectorXd());
    EXPECT_TRUE(holds) << holds.cause();
    expect_passed(simulate<integrator::explicit_runge_kutta>(m, cranks(q, other, q, -2), {}, {0, 1}));
  }
}

// Positions where J is exactly singular.
template <integrator by>
void can_be_begun_at_any_tolerance() {
  const model m = derive<double_four_bar::System>();
  for (const double tolerance : {1e-6, 1e-12}) {
    const auto run = simulate<by>(m, cranks(0, 0, 0, -2), {}, {0, 1}, {.relative_tolerance = tolerance});
    ASSERT_TRUE(run) << tolerance << ": " << run.cause();
    EXPECT_NEAR(energy(run.state), energy(run.trajectory[0].x), 1e-6 + 3e3 * tolerance) << tolerance;
  }
}

TEST(singular_positions, can_be_begun_at_by_every_integrator) {
  can_be_begun_at_any_tolerance<integrator::adams>();
  can_be_begun_at_any_tolerance<integrator::bdf>();
  can_be_begun_at_any_tolerance<integrator::implicit_runge_kutta>();
  can_be_begun_at_any_tolerance<integrator::differential_algebraic>();
}

TEST(singular_positions, name_the_redundant_constraints) {
  using double_four_bar::System;
  auto at = double_four_bar::upright();
  EXPECT_TRUE(check_independence<System>(at));
  EXPECT_EQ(check_independence<System>(at).rank, 4);
  at = state<System>::Zero();
  model m = derive<System>();
  for (const independence& found :
       {check_independence<System>(at), check_independence(m, Eigen::VectorXd(at))}) {
    EXPECT_EQ(found.cause(), "velocity constraint 1 depends on other constraints at this state");
    EXPECT_EQ(found.rank, 2);
    EXPECT_EQ(found.repeated, (std::vector{1, 3})); // along the bars
  }
}

/// u̇ and λ of M u̇ = f + Jᵀ λ and J u̇ + γ = 0: the minimum-norm solution by Eigen.
template <class System>
Eigen::VectorXd decomposed(const state<System>& x) {
  using eom = equations_of_motion<System>;
  constexpr int p = eom::speeds, m = 4;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(p + m, p + m);
  Eigen::VectorXd right(p + m);
  all.topLeftCorner(p, p) = eom::unreduced_mass_matrix(x);
  all.bottomLeftCorner(m, p) = eom::constraint_jacobian(x);
  all.topRightCorner(p, m) = -all.bottomLeftCorner(m, p).transpose();
  right << eom::unreduced_forcing(x), -eom::constraint_bias(x);
  return all.completeOrthogonalDecomposition().solve(right);
}

TEST(singular_positions, have_multipliers_of_minimum_norm) {
  using double_four_bar::System;
  model m = derive<System>();
  for (const double q : {0.0, pi, 0.3, 1.9}) {
    state<System> x = state<System>::Zero();
    x.head<3>().setConstant(q), x.segment<3>(5).setConstant(-2);
    const Eigen::VectorXd expected = decomposed<System>(x);
    const auto compiled = find_least_multipliers<System>(x);
    const auto interpreted = find_least_multipliers(m, Eigen::VectorXd(x));
    EXPECT_EQ(compiled.cause(), "");
    EXPECT_LT((compiled.udot - expected.head<5>()).norm(), 1e-12 * expected.norm());
    EXPECT_LT((compiled.multipliers - expected.tail<4>()).norm(), 1e-12 * expected.norm());
    EXPECT_LT((interpreted.udot - compiled.udot).norm(), 1e-12 * expected.norm());
    EXPECT_LT((interpreted.multipliers - compiled.multipliers).norm(), 1e-12 * expected.norm());
    const bool is_in_line = std::abs(std::sin(q)) < 1e-9;
    EXPECT_EQ(compiled.constraints.cause(),
              is_in_line ? "velocity constraint 1 depends on other constraints at this state" : "");
    EXPECT_EQ(interpreted.constraints.repeated, compiled.constraints.repeated);
    if (!is_in_line) {
      EXPECT_LT((compiled.multipliers - equations_of_motion<System>::multipliers(x)).norm(),
                1e-12 * expected.norm());
    }
  }
}

// Two aligned bars whose end is pulled further.
TEST(singular_positions, report_constraints_that_contradict_each_other) {
  using namespace led_bars;
  const state<System> x = state<System>::Zero();
  const input_values<System> drawn(2, 0, 0.3);
  const auto found = find_least_multipliers<System>(x, parameter_values<System>(), drawn);
  EXPECT_EQ(found.cause(), "the constraints that are redundant at this state contradict the others");
  EXPECT_EQ(found.constraints.cause(), "velocity constraint 1 depends on other constraints at this state");
  EXPECT_EQ(find_least_multipliers<System>(x).cause(), "x has no finite value");
}

// A state on the circle where the constraint cannot be solved for the dependent speed.
TEST(singular_positions, of_the_choice_of_dependent_speeds_do_not_affect_the_motion) {
  const model m = derive<pendulum_nonminimal::System>();
  const auto run =
      simulate(m, {{"q1", 0}, {"q2", 1}, {"u1", 3}, {"u2", 0}}, {{"m", 1}, {"L", 1}, {"g", 9.81}}, {0, 2});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.trajectory[0].x["u1"], 3);
  for (const sample<model>& s : run.trajectory) {
    ASSERT_NEAR(s.x["q1"] * s.x["q1"] + s.x["q2"] * s.x["q2"], 1, 1e-12);
    const double kinetic = (s.x["u1"] * s.x["u1"] + s.x["u2"] * s.x["u2"]) / 2;
    ASSERT_NEAR(kinetic - 9.81 * s.x["q1"], 4.5, 1e-5) << s.t;
  }
}

TEST(singular_positions, end_a_motion_that_cannot_continue) {
  led_bars::ends_where_they_are_stretched<integrator::explicit_runge_kutta>();
  led_bars::ends_where_they_are_stretched<integrator::adams>();
  led_bars::ends_where_they_are_stretched<integrator::differential_algebraic>();
}

} // namespace
