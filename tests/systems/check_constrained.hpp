// Systems with constraints or prescribed motion: compares results that depend on no convention, by the names
// of symbols, with reference results and with systems written by hand.
#pragma once

#include "systems/checked_system.hpp"
#include "systems/hand_written.hpp"

#include <algorithm>

namespace check {

using hand_written::numbers;
using hand_written::pick;
using kanexpr::symbolic::symbol_kind;

inline bool holds(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

// Bound parameters are not in any vector.
template <class System>
kanexpr::parameter_values<System> parameters_by_name(const numbers& values) {
  kanexpr::parameter_values<System> p;
  const std::vector<std::string> called = names<System>(symbol_kind::parameter);
  for (int i = 0; i < p.size(); ++i) p(i) = values.at(called[static_cast<std::size_t>(i)]);
  return p;
}

template <class System>
kanexpr::input_values<System> inputs_by_name(const std::vector<std::string>& called, const VectorXd& values) {
  return kanexpr::input_values<System>(pick(names<System>(symbol_kind::input), called, values));
}

template <class System>
kanexpr::state<System> state_by_name(const std::vector<std::string>& q_names, const VectorXd& q,
                                     const std::vector<std::string>& u_names, const VectorXd& u) {
  return stacked<System>(pick(names<System>(symbol_kind::coordinate), q_names, q),
                         pick(names<System>(symbol_kind::speed), u_names, u));
}

// The value of a result that may have encountered a singularity.
template <class Result>
bool solved(const Result& result) {
  if constexpr (requires { result.status; })
    return static_cast<bool>(result.status);
  else
    return true;
}

// Compares accelerations and rates at one state with reference values of the same names; the reference may
// have more of them.
template <class System, class Parameters, class Inputs>
void check_rates(const kanexpr::state<System>& x, const Parameters& p, const Inputs& r,
                 const std::vector<std::string>& q_names, const VectorXd& qdot,
                 const std::vector<std::string>& u_names, const VectorXd& udot, double tolerance) {
  using eom = kanexpr::equations_of_motion<System>;
  const auto [rates, accelerations, whole] =
      without_heap(eom::together(eom::qdot, eom::udot, eom::rhs), x, p, r);
  EXPECT_TRUE(solved(accelerations)) << "singular";
  EXPECT_TRUE(oracle::close(rates, pick(names<System>(symbol_kind::coordinate), q_names, qdot), tolerance));
  EXPECT_TRUE(
      oracle::close(accelerations, pick(names<System>(symbol_kind::speed), u_names, udot), tolerance));
  EXPECT_EQ(whole, stacked<System>(rates, accelerations));
}

template <class System>
VectorXd without_dependent(const VectorXd& speeds, const oracle::system& reference) {
  const std::vector<std::string> called = names<System>(symbol_kind::speed);
  std::vector<std::string> free;
  for (const std::string& name : called)
    if (!holds(reference.u_dependent, name)) free.push_back(name);
  return pick(free, called, speeds);
}

// The oracle must have every coordinate and speed of the system.
template <class System>
void constrained_against_oracle(const std::string& name) {
  using eom = kanexpr::equations_of_motion<System>;
  const oracle::system reference = oracle::load(name);
  for (const std::string& q : names<System>(symbol_kind::coordinate)) EXPECT_TRUE(holds(reference.q, q)) << q;
  for (const std::string& u : names<System>(symbol_kind::speed)) EXPECT_TRUE(holds(reference.u, u)) << u;
  for (const std::string& r : names<System>(symbol_kind::input)) EXPECT_TRUE(holds(reference.r, r)) << r;
  const auto p = parameters_by_name<System>(reference.parameters);

  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::state& s : reference.states) {
    const auto x = state_by_name<System>(reference.q, s.q, reference.u, s.u);
    const auto r = inputs_by_name<System>(reference.r, s.r);
    check_rates<System>(x, p, r, reference.q, s.qdot, reference.u, s.udot, 1e-12);

    const auto [mass_matrix, forcing] = without_heap(eom::together(eom::mass_matrix, eom::forcing), x, p, r);
    const VectorXd free =
        without_dependent<System>(pick(names<System>(symbol_kind::speed), reference.u, s.udot), reference);
    EXPECT_TRUE(oracle::close(mass_matrix * free, forcing, 1e-11));
    EXPECT_TRUE(oracle::close(mass_matrix.transpose(), mass_matrix, 1e-13));
    if (s.kinetic_energy) {
      const double kinetic = without_heap(eom::kinetic_energy, x, p, r);
      EXPECT_NEAR(kinetic, s.kinetic_energy.value(), 1e-12 * kinetic);
      const VectorXd u = without_dependent<System>(x.u(), reference);
      EXPECT_NEAR(u.dot(mass_matrix * u) / 2, kinetic, 1e-12 * kinetic);
    }
    if (has_gravity<System>() && s.potential_energy) {
      const double potential = without_heap(eom::potential_energy, x, p, r);
      EXPECT_NEAR(potential, s.potential_energy.value(), 1e-12 * std::abs(potential));
    }
  }
}

// The reference's states satisfy the constraints up to rounding.
template <class System>
void residuals_vanish(const std::string& name) {
  using eom = kanexpr::equations_of_motion<System>;
  const oracle::system reference = oracle::load(name);
  const auto p = parameters_by_name<System>(reference.parameters);
  for (const oracle::state& s : reference.states) {
    const auto x = state_by_name<System>(reference.q, s.q, reference.u, s.u);
    const auto r = inputs_by_name<System>(reference.r, s.r);
    if constexpr (System::record.configuration_constraints.size > 0) {
      const auto gap = without_heap(eom::configuration_residual, x, p, r);
      EXPECT_EQ(gap.size(), s.configuration_residual.size());
      EXPECT_LE(gap.cwiseAbs().maxCoeff(), 1e-15 * (1 + x.q().cwiseAbs().maxCoeff()));
    }
    const auto slip = without_heap(eom::velocity_residual, x, p, r);
    EXPECT_EQ(slip.size(), s.velocity_residual.size());
    EXPECT_LE(slip.cwiseAbs().maxCoeff(), 1e-15 * (1 + x.u().cwiseAbs().maxCoeff()));
  }
}

// A state that is admissible for a system written by hand, with coordinates up to `reach` and rates up to
// `pace`.
struct feasible {
  VectorXd q, qdot;
};
inline feasible any_feasible(const hand_written::system& hand, const VectorXd& reach, double pace,
                             std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return unit(random); };
  while (true) {
    VectorXd q = VectorXd::NullaryExpr(reach.size(), any).cwiseProduct(reach);
    if (!hand_written::close(hand, q)) continue;
    const VectorXd rates = pace * VectorXd::NullaryExpr(reach.size(), any);
    return {q, hand_written::allowed(hand, q, rates)};
  }
}

// Compares the accelerations of the system with those of the handwritten one.
template <class System>
void against_hand_written(const hand_written::system& hand, const feasible& at,
                          const kanexpr::parameter_values<System>& p, const kanexpr::input_values<System>& r,
                          double tolerance) {
  using eom = kanexpr::equations_of_motion<System>;
  const hand_written::solution expected = hand_written::solve(hand, at.q, at.qdot);
  const auto x = state_by_name<System>(hand.q, at.q, hand.u, expected.speeds);
  check_rates<System>(x, p, r, hand.q, at.qdot, hand.u, expected.udot, tolerance);
  EXPECT_NEAR(without_heap(eom::kinetic_energy, x, p, r), expected.kinetic_energy,
              1e-13 * (1 + expected.kinetic_energy));
}

// The constraint forces, if both systems have the same constraints in the same order.
template <class System>
void same_multipliers(const hand_written::system& hand, const feasible& at,
                      const kanexpr::parameter_values<System>& p, const kanexpr::input_values<System>& r,
                      double tolerance) {
  using eom = kanexpr::equations_of_motion<System>;
  const hand_written::solution expected = hand_written::solve(hand, at.q, at.qdot);
  const auto x = state_by_name<System>(hand.q, at.q, hand.u, expected.speeds);
  const auto forces = without_heap(eom::multipliers, x, p, r);
  EXPECT_TRUE(solved(forces));
  EXPECT_TRUE(oracle::close(forces, expected.multipliers, tolerance));
}

// Compares the rate of the kinetic energy with the power of all forces.
template <class System>
void energy_rate_is_power_of(const hand_written::system& hand, const feasible& at,
                             const kanexpr::parameter_values<System>& p,
                             const kanexpr::input_values<System>& r) {
  using eom = kanexpr::equations_of_motion<System>;
  const hand_written::solution expected = hand_written::solve(hand, at.q, at.qdot);
  const auto x = state_by_name<System>(hand.q, at.q, hand.u, expected.speeds);
  const energy_rates energy = energy_rates_at<System>(x, p, without_heap(eom::rhs, x, p, r));
  EXPECT_NEAR(energy.kinetic, expected.power,
              1e-10 * (1 + expected.kinetic_energy + std::abs(expected.power)));
}

} // namespace check
