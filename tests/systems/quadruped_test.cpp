// builds: g++
#include "runtime/agreement.hpp"
#include "systems/check_robot_against_oracle.hpp"
#include "systems/checked_system.hpp"
#include "systems/robot_results.hpp"

#include <models/quadruped.hpp>

namespace {

using system = quadruped::System;
using eom = kanexpr::equations_of_motion<system>;

static_assert(check::robot_cost<system>() <= 3040); // including q̇ of the base

TEST(quadruped, agrees_with_the_oracle) {
  check::robot_against_oracle<system>("quadruped_anymal", check::floating_base);
}

TEST(quadruped, compiled_and_interpreted_results_are_identical) { agreement::check_rhs<system>(); }

TEST(quadruped, torques_bring_the_energy) {
  for (const oracle::robot_state& s : oracle::load_robot("quadruped_anymal").states) {
    const check::convention seen = check::floating_base(s.q, s.u);
    const auto x = check::stacked<system>(s.q, seen.turn.transpose() * s.u);
    eom::state rates;
    rates << check::without_heap(eom::qdot, x), seen.turn.transpose() * s.udot - seen.extra;
    const check::energy_rates energy = check::energy_rates_along<system>(x, rates);
    EXPECT_NEAR(energy.kinetic + energy.potential, s.torque.dot(s.u), 1e-10 * std::abs(energy.kinetic));
  }
}

} // namespace
