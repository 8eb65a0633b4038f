// builds: g++
#include "systems/andrews_reference.hpp"
#include "systems/check_constrained.hpp"

#include <models/andrews.hpp>

namespace {

using system = andrews::System;
using eom = kanexpr::equations_of_motion<system>;
using andrews_reference::vector7;

TEST(andrews, starts_as_published) {
  const auto x = check::stacked<system>(andrews_reference::start, vector7::Zero());
  const auto udot = check::without_heap(eom::udot, x);
  EXPECT_TRUE(udot.status);
  EXPECT_TRUE(oracle::close(udot, andrews_reference::start_acceleration, 1e-10));
  EXPECT_LE(check::without_heap(eom::configuration_residual, x).norm(), 1e-16);
}

// The publication writes the forces on the other side of the equations.
TEST(andrews, is_held_together_as_published) {
  const auto x = check::stacked<system>(andrews_reference::start, vector7::Zero());
  const auto forces = check::without_heap(eom::multipliers, x);
  EXPECT_TRUE(oracle::close(-forces, andrews_reference::start_multipliers, 1e-10));
}

TEST(andrews, agrees_with_the_published_formulas_everywhere) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> little(-0.4, 0.4), much(-300, 300);
  for (int repeat = 0; repeat < 20;) {
    vector7 q = andrews_reference::start + vector7::NullaryExpr([&] { return little(random); });
    if (!andrews_reference::close(q)) continue;
    ++repeat;
    const vector7 rates = andrews_reference::allowed(q, vector7::NullaryExpr([&] { return much(random); }));
    const auto x = check::stacked<system>(q, rates);
    const andrews_reference::solution expected = andrews_reference::solve(q, rates);
    const auto [udot, multipliers] = check::without_heap(eom::together(eom::udot, eom::multipliers), x);
    EXPECT_TRUE(udot.status);
    EXPECT_TRUE(oracle::close(udot, expected.acceleration, 1e-11));
    EXPECT_TRUE(oracle::close(-multipliers, expected.multipliers, 1e-11));
    EXPECT_LE(check::without_heap(eom::velocity_residual, x).norm(), 1e-12);
  }
}

} // namespace
