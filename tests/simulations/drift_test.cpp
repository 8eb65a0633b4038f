// builds: g++
// Configuration constraints hold in long simulations.
#include <kanexpr/simulate.hpp>

#include <models/pendulum_nonminimal.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace kanexpr;

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

template <integrator by>
void pendulum_stays_on_its_circle(double lost) {
  using namespace pendulum_nonminimal;
  const auto run =
      simulate<System, by>({{q1, 1}, {q2, 0}, {u1, 0}, {u2, 0.5}}, {{m, 1}, {L, 1}, {g, 9.81}}, {0, 1000});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.time, 1000);
  EXPECT_GT(run.trajectory.size(), 10000u);
  EXPECT_LE(largest(run.trajectory.constraint_residuals()), 1e-8);
  const std::vector<double> energy = run.trajectory.energies().total;
  for (const double e : energy) EXPECT_NEAR(e, energy[0], lost * 0.125); // of the kinetic energy at the start
}

TEST(drift, of_a_pendulum_by_two_coordinates_in_1000_seconds) {
  pendulum_stays_on_its_circle<integrator::adams>(1e-4);
  pendulum_stays_on_its_circle<integrator::bdf>(1e-2);
  pendulum_stays_on_its_circle<integrator::explicit_runge_kutta>(1e-4);
  pendulum_stays_on_its_circle<integrator::implicit_runge_kutta>(1e-5);
  pendulum_stays_on_its_circle<integrator::differential_algebraic>(1e-4);
}

} // namespace
