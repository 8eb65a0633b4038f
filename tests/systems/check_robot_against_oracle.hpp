// Robots with numbers and a motor in each joint: against another library's results, and power against energy.
#pragma once

#include "systems/checked_system.hpp"

#include <Eigen/Cholesky>

namespace check {

// How the reference sees the accelerations of a model: a_reference = turn · (a + extra).
struct convention {
  MatrixXd turn;
  VectorXd extra;
};

// A robot that stands on the ground: joint rates, which are the same to everyone.
struct on_the_ground {
  template <class State>
  static convention at(const State& x) {
    return {MatrixXd::Identity(x.u().size(), x.u().size()), VectorXd::Zero(x.u().size())};
  }
};

// One function for all that is asked of a robot: what compiles long is compiled once.
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

template <class System, class Base = on_the_ground>
void robot_against_oracle(const std::string& name) {
  using inputs = kanexpr::input_values<System>;
  using speeds = Eigen::Matrix<double, kanexpr::state<System>::speeds, 1>;
  constexpr int joints = inputs::RowsAtCompileTime;

  const oracle::robot reference = oracle::load_robot(name);
  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::robot_state& s : reference.states) {
    auto x = stacked<System>(s.q, s.u);
    const auto [turn, extra] = Base::at(x);
    x.u() = turn.transpose() * s.u;
    const speeds a = turn.transpose() * s.a - extra;
    speeds on_base = turn.transpose() * s.torque;
    on_base.template tail<joints>().setZero();

    const auto [m, free, falling] = robot_equations<System>(x, inputs());
    EXPECT_TRUE(oracle::close(turn * m * turn.transpose(), s.mass_matrix, 1e-11));
    EXPECT_TRUE(oracle::close(turn * (-free - m * extra), s.bias, 1e-11));
    EXPECT_TRUE(oracle::close(turn * (m * a - free), s.inverse_dynamics, 1e-11));

    const auto [same, forcing, rhs] = robot_equations<System>(x, inputs(s.torque.tail<joints>()));
    const speeds udot = rhs.template tail<speeds::RowsAtCompileTime>();
    EXPECT_TRUE(oracle::close(m * udot, forcing, 1e-11));
    EXPECT_TRUE(oracle::close(turn * (udot + m.ldlt().solve(on_base) + extra), s.udot, 1e-11));
  }
}

// The motors alone bring energy in.
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
