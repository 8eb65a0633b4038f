// builds: g++
// Quaternions keep norm 1 in long simulations.
#include "steps/quaternions.hpp"

#include <kanexpr/simulate.hpp>

#include <models/pivot_body.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace kanexpr;

template <class System>
double most_off_one(const simulation<System>& run) {
  double most = 0;
  for (const sample<System>& s : run.trajectory)
    most = std::max(most, steps::unit_quaternions<System>::residual(s.x).cwiseAbs().maxCoeff());
  return most;
}

namespace body {

using namespace pivot_body;

simulation_options<System> options(double tolerance) {
  simulation_options<System> o;
  o.inputs = {{T1, 0}, {T2, 0}, {T3, 0}};
  o.relative_tolerance = tolerance, o.absolute_tolerance = tolerance / 100;
  return o;
}

template <integrator by = integrator::adams>
auto tumble(double end, simulation_options<System> o, double first = 1) {
  const given_parameters<System> p{{m, 1},    {Ixx, 1}, {Iyy, 2}, {Izz, 2.5}, {Ixy, 0.1},
                                   {g, 9.81}, {a, 0.1}, {b, 0.2}, {c, 0.3}};
  return simulate<System, by>({{e0, first}, {e1, 0}, {e2, 0}, {e3, 0}, {u1, 3}, {u2, 1}, {u3, -2}}, p,
                              {0, end}, o);
}

template <integrator by>
void keeps_its_norm(double energy_lost) {
  const auto run = tumble<by>(1000, options(1e-8));
  ASSERT_TRUE(run) << run.cause();
  EXPECT_GT(run.trajectory.size(), 10000u);
  EXPECT_LT(most_off_one(run), 1e-12);
  EXPECT_LT(std::abs(run.state.template head<4>().norm() - 1), 1e-12);
  const std::vector<double> energy = run.trajectory.energies().total;
  for (const double e : energy) EXPECT_NEAR(e, energy[0], energy_lost * 8); // plus that of the motion
}

} // namespace body

TEST(quaternions, keep_their_norm_for_1000_seconds) {
  body::keeps_its_norm<integrator::adams>(1e-4);
  body::keeps_its_norm<integrator::bdf>(1e-3);
  body::keeps_its_norm<integrator::explicit_runge_kutta>(1e-5);
  body::keeps_its_norm<integrator::implicit_runge_kutta>(1e-5);
  body::keeps_its_norm<integrator::differential_algebraic>(1e-4);
}

TEST(quaternions, keep_their_norm_with_coarse_tolerances_and_between_steps) {
  auto o = body::options(1e-4);
  o.output_every = 0.05;
  EXPECT_LT(most_off_one(body::tumble(100, o)), 1e-12);
  EXPECT_LT(most_off_one(body::tumble<integrator::explicit_runge_kutta>(100, o)), 1e-12);
  EXPECT_LT(most_off_one(body::tumble<integrator::bdf>(100, o)), 1e-12);
  EXPECT_LT(most_off_one(body::tumble<integrator::differential_algebraic>(100, o)), 1e-12);
}

TEST(quaternions, that_are_rounded_are_normalized_and_others_rejected) {
  const auto rounded = body::tumble(0.1, body::options(1e-8), 0.999);
  ASSERT_TRUE(rounded) << rounded.cause();
  EXPECT_EQ(rounded.trajectory.front().x[pivot_body::e0], 1);
  const auto twice = body::tumble(0.1, body::options(1e-8), 2);
  EXPECT_EQ(twice.cause(),
            "the simulation ended at t = 0 with e0 = 2, e1 = 0, e2 = 0, e3 = 0, u1 = 3, u2 = 1, u3 = "
            "-2: the norm of the quaternion e0, e1, e2 and e3 is far from 1");
  EXPECT_TRUE(twice.trajectory.empty());
}

TEST(quaternions, that_a_handler_changes_are_normalized) {
  auto o = body::options(1e-8);
  o.events = {event<pivot_body::System>(
      "turned", [](double t, const auto&, const auto&, const auto&) { return t - 0.5; }, crossing::rising,
      [](moment<pivot_body::System>& now) { now.x[pivot_body::e0] += 1e-3; })};
  const auto run = body::tumble(1, o);
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_LT(most_off_one(run), 1e-12);
}

// The kinematic equations of the second body must be solved.
TEST(quaternions, of_two_bodies) {
  using namespace quaternions;
  state<Two> x;
  x[e0] = x[f0] = 1;
  x[u1] = 2, x[v2] = 3;
  const auto run = simulate<Two>(x, {}, {0, 20});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_LT(most_off_one(run), 1e-12);
}

template <integrator by>
void slides_with_norm_one() {
  using namespace quaternions;
  const auto run =
      simulate<Sliding, by>({{e0, 0.9}, {e1, 0.1}, {e3, 0.3}, {u1, 0.2}, {u3, 0.3}}, {{h, 0.2}}, {0, 3});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_LT(most_off_one(run), 1e-12);
  EXPECT_LT(std::ranges::max(run.trajectory.constraint_residuals()), 1e-12);
}

TEST(quaternions, that_a_constraint_binds) {
  slides_with_norm_one<integrator::adams>();
  slides_with_norm_one<integrator::differential_algebraic>();
}

} // namespace
