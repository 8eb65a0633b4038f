// builds: clang++ all
// Lagrange's and Kane's methods give the same motion.
#include <kanexpr/simulate.hpp>

#include <models/pendulum_nonminimal.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace kanexpr;
using namespace pendulum_nonminimal;

const std::initializer_list<named_value> numbers{{m, 0.7}, {L, 1}, {g, 9.81}};

template <integrator by>
void moves_as_by_kane(double tolerance) {
  const auto options = [](const auto& any) {
    auto o = any;
    o.guesses_dependent = true, o.relative_tolerance = 1e-10, o.absolute_tolerance = 1e-12,
    o.output_every = 0.5;
    return o;
  };
  const auto kane = simulate<System, integrator::explicit_runge_kutta>(
      {{q2, 0.6}, {q1, 0.8}, {u2, 0.4}}, numbers, {0, 5}, options(simulation_options<System>()));
  const auto lagrange = simulate<LagrangeSystem, by>({{q2, 0.6}, {q1, 0.8}, {dot(q2), 0.4}}, numbers, {0, 5},
                                                     options(simulation_options<LagrangeSystem>()));
  ASSERT_TRUE(kane) << kane.cause();
  ASSERT_TRUE(lagrange) << lagrange.cause();
  ASSERT_EQ(lagrange.trajectory.size(), kane.trajectory.size());
  for (std::size_t i = 0; i < kane.trajectory.size(); ++i) {
    EXPECT_NEAR(lagrange.trajectory[i].x[q2], kane.trajectory[i].x[q2], tolerance);
    EXPECT_NEAR(lagrange.trajectory[i].x[dot(q1)], kane.trajectory[i].x[u1], 5 * tolerance);
  }
  EXPECT_LE(std::ranges::max(lagrange.trajectory.constraint_residuals()), 1e-12);
}

TEST(lagrange, moves_as_by_kane_with_every_integrator) {
  moves_as_by_kane<integrator::adams>(1e-7);
  moves_as_by_kane<integrator::bdf>(1e-6);
  moves_as_by_kane<integrator::explicit_runge_kutta>(1e-9);
  moves_as_by_kane<integrator::implicit_runge_kutta>(1e-8);
  moves_as_by_kane<integrator::differential_algebraic>(1e-6);
}

TEST(lagrange, names_rates_that_are_missing) {
  EXPECT_EQ((simulate<LagrangeSystem>({{q2, 0.6}, {q1, 0.8}}, numbers, {0, 5}).cause()),
            "the rate of coordinate q2 has no value");
}

} // namespace
