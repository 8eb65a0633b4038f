// builds: g++
#include "systems/check_constrained.hpp"

#include <models/rattleback.hpp>

namespace {

using system = rattleback::System;
using eom = kanexpr::equations_of_motion<system>;

// Kane & Levinson's stone, with or without friction, in SI units.
check::numbers stone(double sigma) {
  return {{"a", 0.2},      {"b", 0.03},     {"c", 0.02},     {"h", 0.01},      {"m", 1.0}, {"Ixx", 0.0002},
          {"Iyy", 0.0016}, {"Izz", 0.0017}, {"Ixy", -2e-05}, {"sigma", sigma}, {"g", 9.81}};
}

// Arbitrary yaw, and roll and pitch away from the singularities of the angles.
check::feasible any_motion(const hand_written::system& hand, std::mt19937& random) {
  return check::any_feasible(hand, check::VectorXd{{3, 1.2, 1.2, 0, 0}}, 5, random);
}

TEST(rattleback, agrees_with_newton_and_euler) {
  std::mt19937 random(1);
  const hand_written::system hand = hand_written::rattleback(stone(0.003));
  const auto p = check::parameters_by_name<system>(stone(0.003));
  for (int repeat = 0; repeat < 20; ++repeat)
    check::against_hand_written<system>(hand, any_motion(hand, random), p, {}, 1e-12);
}

TEST(rattleback, friction_takes_its_energy) {
  std::mt19937 random(2);
  const hand_written::system hand = hand_written::rattleback(stone(0.003));
  const auto p = check::parameters_by_name<system>(stone(0.003));
  for (int repeat = 0; repeat < 20; ++repeat)
    check::energy_rate_is_power_of<system>(hand, any_motion(hand, random), p, {});
}

// One step of the classic Runge-Kutta method.
eom::state after(const eom::state& x, const eom::parameters& p, double step) {
  const auto rate = [&](const eom::state& at) { return eom::state(eom::rhs(at, p)); };
  const eom::state k1 = rate(x), k2 = rate(eom::state(x + step / 2 * k1)),
                   k3 = rate(eom::state(x + step / 2 * k2)), k4 = rate(eom::state(x + step * k3));
  return eom::state(x + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
}

TEST(rattleback, turns_round_and_keeps_its_energy_without_friction) {
  using namespace rattleback;
  const auto p = check::parameters_by_name<system>(stone(0));
  eom::state x;
  x.setZero();
  x[q2] = x[q3] = 0.0087;
  x[u3] = -5;
  const auto energy = [&] { return eom::kinetic_energy(x, p) + eom::potential_energy(x, p); };
  const double at_first = energy();
  for (int i = 0; i < 50000; ++i) x = after(x, p, 1e-4);
  EXPECT_GT(x[u3], 0);
  EXPECT_NEAR(energy(), at_first, 1e-6 * std::abs(at_first));
}

} // namespace
