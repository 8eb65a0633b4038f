// Compares all results of systems with symbols with reference results, and power with energy.
#pragma once

#include "systems/checked_system.hpp"

namespace check {

template <class System>
kanexpr::parameter_values<System> parameters_of(const oracle::system& reference) {
  kanexpr::parameter_values<System> p;
  const std::vector<std::string> called = names<System>(kanexpr::symbolic::symbol_kind::parameter);
  EXPECT_EQ(called.size(), reference.parameters.size());
  for (int i = 0; i < p.size(); ++i) p(i) = reference.parameters.at(called[static_cast<std::size_t>(i)]);
  return p;
}

template <class System>
void against_oracle(const std::string& name) {
  using kanexpr::symbolic::symbol_kind;
  using eom = kanexpr::equations_of_motion<System>;
  constexpr auto everything =
      eom::together(eom::mass_matrix, eom::forcing, eom::qdot, eom::udot, eom::mass_matrix_full,
                    eom::forcing_full, eom::rhs, eom::kinetic_energy, eom::potential_energy);
  constexpr auto balance = eom::together(eom::inertia_forces, eom::active_forces);

  const oracle::system reference = oracle::load(name);
  EXPECT_EQ(names<System>(symbol_kind::coordinate), reference.q);
  EXPECT_EQ(names<System>(symbol_kind::speed), reference.u);
  EXPECT_EQ(names<System>(symbol_kind::input), reference.r);
  const auto p = parameters_of<System>(reference);

  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::state& s : reference.states) {
    const auto x = stacked<System>(s.q, s.u);
    const kanexpr::input_values<System> r(s.r);
    const auto [mass_matrix, forcing, qdot, udot, mass_matrix_full, forcing_full, rhs, kinetic, potential] =
        without_heap(everything, x, p, r);
    EXPECT_TRUE(oracle::close(mass_matrix, s.mass_matrix, 1e-12));
    EXPECT_TRUE(oracle::close(forcing, s.forcing, 1e-12));
    EXPECT_TRUE(oracle::close(qdot, s.qdot, 1e-12));
    EXPECT_TRUE(oracle::close(udot, s.udot, 1e-12));
    EXPECT_NEAR(kinetic, s.kinetic_energy.value(), 1e-12 * std::abs(kinetic));
    const double expected_potential = has_gravity<System>() ? s.potential_energy.value() : 0;
    EXPECT_NEAR(potential, expected_potential, 1e-12 * std::abs(potential));

    const auto [inertia, active] = without_heap(balance, 0.0, x, p, r, udot);
    const double heaviest = active.cwiseAbs().maxCoeff() + forcing.cwiseAbs().maxCoeff();
    EXPECT_LE((inertia + active).cwiseAbs().maxCoeff(), 1e-12 * heaviest);

    MatrixXd full = MatrixXd::Identity(x.size(), x.size());
    full.bottomRightCorner(s.u.size(), s.u.size()) = mass_matrix;
    EXPECT_EQ(mass_matrix_full, full);
    EXPECT_EQ(forcing_full, stacked<System>(qdot, forcing));
    EXPECT_EQ(rhs, stacked<System>(qdot, udot));
  }
}

// The power of all forces is the rate of kinetic energy; without gravity, it is that of the total energy.
template <class System>
void energy_rate_is_power(const std::string& name) {
  using eom = kanexpr::equations_of_motion<System>;
  const oracle::system reference = oracle::load(name);
  const auto p = parameters_of<System>(reference);
  auto weightless = p;
  weightless[kanexpr::parameter<"g">()] = 0;

  std::mt19937 random(1);
  for (const oracle::state& s : reference.states) {
    const auto x = disturbed<System>(stacked<System>(s.q, s.u), random);
    const kanexpr::input_values<System> r(s.r);
    const auto [rates, force] = without_heap(eom::together(eom::rhs, eom::active_forces), x, p, r);
    const energy_rates energy = energy_rates_at<System>(x, p, rates);
    const double scale = force.cwiseAbs().dot(x.u().cwiseAbs());
    EXPECT_NEAR(energy.kinetic, force.dot(x.u()), 1e-10 * scale);
    if (has_gravity<System>()) {
      const auto other_force = without_heap(eom::active_forces, x, weightless, r);
      EXPECT_NEAR(energy.kinetic + energy.potential, other_force.dot(x.u()), 1e-10 * scale);
    }
  }
}

} // namespace check
