// builds: g++
// Mechanisms that pass positions where their constraints depend on each other, or where these cannot be
// solved for what is dependent.
#include "simulate/led_bars.hpp"
#include "steps/double_four_bar.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/simulate/model.hpp>

#include <models/pendulum_nonminimal.hpp>

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
void passes_at_any_tolerance(double until = 10, double least_change = 1e-6) {
  const model m = derive<double_four_bar::System>();
  for (const double tolerance : {1e-7, 1e-10, 1e-12}) {
    const auto run = simulate<by>(m, cranks(pi / 2, pi / 2, pi / 2, -1), {}, {0, until},
                                  {.relative_tolerance = tolerance});
    ASSERT_TRUE(run) << tolerance << ": " << run.cause();
    const double first = energy(run.trajectory[0].x);
    for (const sample<model>& s : run.trajectory) {
      ASSERT_NEAR(energy(s.x), first, (std::max)(least_change, 1e4 * tolerance))
          << tolerance << ", t = " << s.t;
      for (const char* other : {"q2", "q3"}) // on the branch of equal cranks
        ASSERT_NEAR(s.x[other], s.x["q1"], 1e-3);
    }
    EXPECT_LT(run.state["q1"], -2 * until);
  }
}

TEST(singular_positions, are_passed_at_any_tolerance_and_leave_the_energy) {
  passes_at_any_tolerance<integrator::adams>();
  passes_at_any_tolerance<integrator::bdf>(2, 1e-5);
  passes_at_any_tolerance<integrator::explicit_runge_kutta>();
  passes_at_any_tolerance<integrator::implicit_runge_kutta>(2);
}

// All bars in line, where sines of whole turns leave their own rounding.
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
    const auto run = simulate<integrator::explicit_runge_kutta>(m, cranks(q, other, q, -2), {}, {0, 1});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_NEAR(energy(run.state), energy(run.trajectory[0].x), 1e-5);
  }
}

TEST(singular_positions, say_which_constraints_repeat_others) {
  using double_four_bar::System;
  auto at = double_four_bar::upright();
  EXPECT_TRUE(check_independence<System>(at));
  EXPECT_EQ(check_independence<System>(at).rank, 4);
  at = state<System>::Zero();
  model m = derive<System>();
  for (const independence& found :
       {check_independence<System>(at), check_independence(m, Eigen::VectorXd(at))}) {
    EXPECT_EQ(found.cause(), "constraint 1 on the speeds repeats others here");
    EXPECT_EQ(found.rank, 2);
    EXPECT_EQ(found.repeated, (std::vector{1, 3})); // along the bars
  }
}

// A state on the circle where it cannot be solved for what is dependent.
TEST(singular_positions, of_the_choice_of_dependent_speeds_are_none_of_the_motion) {
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

TEST(singular_positions, end_a_motion_that_has_no_way_on) {
  led_bars::ends_where_they_are_stretched<integrator::explicit_runge_kutta>();
  led_bars::ends_where_they_are_stretched<integrator::adams>();
}

} // namespace
