// builds: clang++
// A double pendulum without friction conserves its energy.
#include <kanexpr/simulate.hpp>

#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace kanexpr;
using namespace double_pendulum;

template <integrator by>
void keeps_its_energy() {
  const auto run = simulate<System, by>(
      {{q1, 0.5 - std::numbers::pi / 2}, {q2, 0.3}, {u1, 0}, {u2, 0}},
      {{m1, 1}, {m2, 1.2}, {d1, 0.5}, {d2, 0.5}, {l1, 1}, {I1, 0.1}, {I2, 0.1}, {g, 9.81}, {c1, 0}, {c2, 0}},
      {0, 100}, {.inputs = {{T1, 0}, {T2, 0}}, .relative_tolerance = 1e-10, .absolute_tolerance = 1e-12});
  ASSERT_TRUE(run) << run.cause();
  const auto [kinetic, potential, total] = run.trajectory.energies();
  const double swings = std::ranges::max(kinetic); // the potential energy has no zero of its own
  for (const double e : total) EXPECT_NEAR(e, total[0], 1e-8 * swings);
}

TEST(energy, of_a_double_pendulum_in_100_seconds) {
  keeps_its_energy<integrator::adams>();
  keeps_its_energy<integrator::explicit_runge_kutta>();
  keeps_its_energy<integrator::implicit_runge_kutta>();
}

} // namespace
