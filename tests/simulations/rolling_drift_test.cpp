// builds: g++
// Velocity constraints hold in long simulations.
#include <kanexpr/simulate.hpp>

#include <models/rolling_disc_constrained.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace kanexpr;
using namespace rolling_disc_constrained;

template <integrator by>
void disc_does_not_slip(double tolerance) {
  const auto run =
      simulate<System, by>({{q1, 0.3}, {q2, 0.2}, {q3, 0}, {q4, 1}, {q5, -1}, {u1, 0.1}, {u2, 9}, {u3, 0.4}},
                           {{r, 0.3}, {m, 2}, {g, 9.81}}, {0, 100}, {.output_every = 0.05});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.trajectory.size(), 2001u);
  EXPECT_LE(std::ranges::max(run.trajectory.constraint_residuals()), 1e-12);
  // A rolling disc has three integrals; one of them is its energy.
  const std::vector<double> energy = run.trajectory.energies().total;
  for (const double e : energy) EXPECT_NEAR(e, energy[0], tolerance * energy[0]);
  // It wobbles all the time, and travels.
  const auto& last = run.trajectory.back().x;
  EXPECT_GT(std::hypot(last[q4] - 1, last[q5] + 1), 1e-2);
}

TEST(drift, of_a_disc_that_rolls_for_100_seconds) {
  disc_does_not_slip<integrator::adams>(1e-5);
  disc_does_not_slip<integrator::bdf>(1e-4);
  disc_does_not_slip<integrator::explicit_runge_kutta>(1e-6);
  disc_does_not_slip<integrator::implicit_runge_kutta>(1e-6);
  disc_does_not_slip<integrator::differential_algebraic>(1e-5);
}

} // namespace
