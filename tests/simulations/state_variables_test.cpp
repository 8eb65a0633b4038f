// builds: clang++
// Motions and operating points of systems with state variables, compared with closed forms.
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/model.hpp>
#include <models/motor_arm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace motor_arm;

kanexpr::parameter_values<System> some_parameters() {
  return {{m, 2},   {l, 0.5},  {g, 9.81}, {n, 20},  {k, 0.05},
          {R, 0.8}, {L, 1e-3}, {kp, 30},  {ki, 20}, {tau, 0.25}};
}

// The filter is linear: its state follows a constant reference as 1 − e^(−t/τ).
template <kanexpr::integrator by>
void follows_the_exponential() {
  const auto run =
      kanexpr::simulate<System, by>({{q, 0}, {u, 0}, {i, 0}, {filtered, 0}, {integral, 0}}, some_parameters(),
                                    {0, 2}, {.inputs = {{reference, 1}}, .relative_tolerance = 1e-10});
  ASSERT_TRUE(run) << run.cause();
  for (const auto& sample : run.trajectory)
    EXPECT_NEAR(sample.x[filtered], 1 - std::exp(-sample.t / 0.25), 1e-8) << "at t = " << sample.t;
}

TEST(simulated_state_variables, follow_the_exponential) {
  follows_the_exponential<kanexpr::integrator::explicit_runge_kutta>();
  follows_the_exponential<kanexpr::integrator::bdf>();
}

// In equilibrium, the integrator supplies the voltage R i for the current that holds the arm.
TEST(operating_point_of_state_variables, holds_the_arm) {
  const kanexpr::parameter_values<System> p = some_parameters();
  const kanexpr::operating_point<System> held({{q, 0.9}}, p,
                                              {.inputs = {{reference, 1}}, .held = {reference}});
  ASSERT_TRUE(held) << held.cause();
  const double current = p[m] * p[g] * p[l] * std::sin(1.0) / (p[n] * p[k]);
  EXPECT_NEAR(held.x[q], 1, 1e-13);
  EXPECT_NEAR(held.x[u], 0, 1e-13);
  EXPECT_NEAR(held.x[filtered], 1, 1e-13);
  EXPECT_NEAR(held.x[i], current, 1e-12 * current);
  EXPECT_NEAR(held.x[integral], p[R] * current / p[ki], 1e-12 * current);
}

TEST(simulated_state_variables, are_columns_of_tables_and_move_as_at_run_time) {
  const std::initializer_list<kanexpr::named_value> start{{"q", 0.1}, {"u", 0}, {"i", 0}, {"f", 0}, {"e", 0}};
  const auto compiled =
      kanexpr::simulate<System>(start, some_parameters(), {0, 1}, {.inputs = {{reference, 1}}});
  ASSERT_TRUE(compiled) << compiled.cause();
  EXPECT_EQ(compiled.trajectory.table().names(),
            (std::vector<std::string>{"t", "q", "u", "i", "f", "e", "r"}));
  EXPECT_EQ(compiled.trajectory.table().units()[3], "A");
  const auto interpreted = kanexpr::simulate(kanexpr::derive<System>(), start,
                                             {{"m", 2},
                                              {"l", 0.5},
                                              {"g", 9.81},
                                              {"n", 20},
                                              {"k", 0.05},
                                              {"R", 0.8},
                                              {"L", 1e-3},
                                              {"kp", 30},
                                              {"ki", 20},
                                              {"tau", 0.25}},
                                             {0, 1}, {.inputs = {{"r", 1}}});
  ASSERT_TRUE(interpreted) << interpreted.cause();
  EXPECT_EQ(interpreted.statistics.steps, compiled.statistics.steps);
  EXPECT_EQ(interpreted.state, compiled.state);
}

} // namespace
