// builds: clang++
// Compiled and run-time systems check states and solve for dependent speeds with the same results.
#include "four_bars.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "runtime/agreement.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/runtime/assemble.hpp>

#include <gtest/gtest.h>

#include <cstdio>

namespace {

using kanexpr::mechanics::quantity;

TEST(assemble, says_that_the_start_is_singular) {
  using System = pendulum_nonminimal::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::parameters p = eom::parameters::Ones();
  eom::state x;
  x << 0.5, 0, 1, 2; // level with the pivot, up and down are equivalent
  const eom::state guess = x;
  const kanexpr::assembly a = kanexpr::assemble<System>(x, p);
  EXPECT_FALSE(a);
  EXPECT_EQ(x, guess);
  EXPECT_EQ(a.cause(), "the search for the dependent coordinates ended at a singularity of the configuration "
                       "constraints, with a residual of 0.75");
  Eigen::VectorXd y = guess;
  auto model = kanexpr::derive<System>();
  EXPECT_EQ(kanexpr::assemble(model, y, p, p).cause(), a.cause());
  EXPECT_EQ(y, guess);
}

Eigen::Vector2d amounts(const kanexpr::consistency& c) {
  return {c.configuration_residual, c.velocity_residual};
}

TEST(check_consistency, names_the_constraint_and_the_amount) {
  using namespace four_bar;
  four_bars b;
  ASSERT_TRUE(kanexpr::assemble<System>(b.x, b.p, b.r));
  auto model = kanexpr::derive<System>();
  const auto both = [&](const four_bars::eom::state& x) {
    const kanexpr::consistency compiled = kanexpr::check_consistency<System>(x, b.p, b.r),
                               derived = kanexpr::check_consistency(model, Eigen::VectorXd(x), b.p, b.r);
    EXPECT_EQ(compiled.cause(), derived.cause());
    agreement::expect_same_bits(amounts(compiled), amounts(derived));
    return compiled;
  };
  EXPECT_TRUE(both(b.x));
  EXPECT_EQ(both(b.x).cause(), "");

  auto moved = b.x;
  moved[u3] += 0.25;
  const double d = moved[q1] + moved[q2] + moved[q3]; // the residual is that of the rocker's end, 1.2 long
  char text[64];
  std::snprintf(text, sizeof text, "velocity constraint 1 has a residual of %.3g", -1.2 * std::sin(d) * 0.25);
  EXPECT_EQ(both(moved).cause(), text);
  EXPECT_LT(both(moved).configuration_residual, 1e-15);
  EXPECT_NEAR(both(moved).velocity_residual, 0.3 * std::max(std::abs(std::sin(d)), std::abs(std::cos(d))),
              1e-14);

  moved = b.x;
  moved[q1] += std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(both(moved));
  moved = b.x;
  moved[u1] = std::numeric_limits<double>::infinity(); // and so are its terms
  EXPECT_FALSE(both(moved));

  b.p[l0] += 0.5; // only along x
  EXPECT_EQ(both(b.x).cause(), "configuration constraint 1 has a residual of -0.5");
  EXPECT_NEAR(both(b.x).configuration_residual, 0.5, 1e-14);
}

TEST(imposed, replaces_the_dependent_speeds) {
  using namespace four_bar;
  four_bars b;
  ASSERT_TRUE(kanexpr::assemble<System>(b.x, b.p, b.r));
  auto model = kanexpr::derive<System>();
  kanexpr::symbolic::matrix energy = model.get(quantity::kinetic_energy);
  const double expected = four_bars::eom::kinetic_energy(b.x, b.p, b.r);
  energy.entries[0] = model.equations().imposed(energy.entries[0]);
  auto bound = model.function(energy);
  auto x = b.x;
  x[u2] = x[u3] = std::numeric_limits<double>::quiet_NaN(); // are not requested
  EXPECT_NEAR(bound(x, b.p, b.r)(0), expected, 1e-14 * expected);
  EXPECT_TRUE(bound.status());
  x[q3] = 0;
  bound(x, b.p, b.r);
  EXPECT_FALSE(bound.status());
}

} // namespace
