// Where something cannot be solved: the compiled and the derived system say the same.
#include "four_bars.hpp"
#include "models/rolling_disc_constrained.hpp"

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace {

using kanexpr::mechanics::quantity;

// The status of ẋ on both sides.
template <class System, class X, class P, class R>
void expect_status(const X& x, const P& p, const R& r, const std::string& cause) {
  using eom = kanexpr::equations_of_motion<System>;
  auto derived = kanexpr::derive<System>();
  auto interpreted = derived.function(derived.rhs());
  interpreted(x, p, r);
  for (const kanexpr::status& s : {eom::rhs(x, p, r).status, interpreted.status()}) {
    EXPECT_EQ(static_cast<bool>(s), cause.empty());
    EXPECT_EQ(s.cause(), cause);
  }
}

TEST(status, is_good_at_regular_states) {
  const four_bars b;
  expect_status<four_bars::System>(b.x, b.p, b.r, "");
}

TEST(status, names_speeds_that_cannot_be_solved_for) {
  four_bars b;
  b.x[four_bar::q3] = 0; // coupler and rocker in line
  expect_status<four_bars::System>(
      b.x, b.p, b.r, "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  b.x[four_bar::q3] = 1e-6; // nearly
  expect_status<four_bars::System>(b.x, b.p, b.r, "");
}

TEST(status, names_rates_that_cannot_be_solved_for) {
  using System = rolling_disc_constrained::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::state x = eom::state::Constant(0.4);
  const eom::parameters p = eom::parameters::Constant(1.1);
  expect_status<System>(x, p, eom::inputs(), "");
  x[rolling_disc_constrained::q2] = std::numbers::pi / 2; // the disc lies flat
  expect_status<System>(
      x, p, eom::inputs(),
      "the kinematic differential equations cannot be solved for the rate of coordinate q1 at this state");
}

TEST(status, is_not_asked_for_what_needs_no_solution) {
  four_bars b;
  b.x[four_bar::q3] = 0;
  const double energy = four_bars::eom::kinetic_energy(b.x, b.p, b.r); // comes without one
  EXPECT_GT(energy, 0);
  auto derived = kanexpr::derive<four_bars::System>();
  auto interpreted = derived.function(derived.get(quantity::kinetic_energy));
  interpreted(b.x, b.p, b.r);
  EXPECT_TRUE(interpreted.status());
}

} // namespace
