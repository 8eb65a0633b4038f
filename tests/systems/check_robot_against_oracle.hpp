// Robots with numeric values and a motor in each joint: comparison with the results of another library, and
// of power with energy.
#pragma once

#include "systems/checked_system.hpp"
#include "systems/robot_results.hpp"

namespace check {

// One function for all results of a robot, because it takes long to compile.
template <class System>
constexpr auto robot_function() {
  using eom = kanexpr::equations_of_motion<System>;
  return eom::together(eom::mass_matrix, eom::forcing, eom::rhs);
}

template <class System>
auto robot_equations(const kanexpr::state<System>& x, const kanexpr::input_values<System>& motors) {
  return without_heap(robot_function<System>(), x, kanexpr::parameter_values<System>(), motors);
}

// Multiplications and additions of one call.
template <class System>
constexpr int robot_cost() {
  return robot_function<System>().cost().multiplications + robot_function<System>().cost().additions;
}

template <class System>
void robot_against_oracle(const std::string& name, seen_by_reference seen_by = on_the_ground) {
  using inputs = kanexpr::input_values<System>;
  const oracle::robot reference = oracle::load_robot(name);
  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::robot_state& s : reference.states) {
    const convention seen = seen_by(s.q, s.u);
    const auto x = stacked<System>(s.q, seen.turn.transpose() * s.u);
    const inputs motors(s.torque.tail(inputs::RowsAtCompileTime));
    const auto at_rest = robot_equations<System>(x, inputs::Zero());
    const auto [mass_matrix, forcing, rhs] = robot_equations<System>(x, motors);
    const robot_results model{mass_matrix, std::get<1>(at_rest), forcing, rhs.tail(s.u.size())};
    expect_reference(model, s, seen, motors.size());
  }
}

// Only the motors supply energy.
template <class System>
void motors_bring_the_energy(const std::string& name) {
  using inputs = kanexpr::input_values<System>;
  constexpr int joints = inputs::RowsAtCompileTime;

  const oracle::robot reference = oracle::load_robot(name);
  std::mt19937 random(1);
  for (const oracle::robot_state& s : reference.states) {
    const auto x = disturbed<System>(stacked<System>(s.q, s.u), random);
    const inputs motors(s.torque.tail<joints>());
    const kanexpr::state<System> rates(std::get<2>(robot_equations<System>(x, motors)));
    const energy_rates energy = energy_rates_along<System>(x, rates);
    const double power = motors.dot(x.u().template tail<joints>());
    EXPECT_NEAR(energy.kinetic + energy.potential, power,
                1e-10 * (std::abs(power) + std::abs(energy.kinetic)));
  }
}

} // namespace check
