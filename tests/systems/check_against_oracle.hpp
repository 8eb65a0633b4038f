// Systems with symbols: everything against the reference results, and power against energy.
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
    EXPECT_TRUE(oracle::close(as_matrix(mass_matrix), s.mass_matrix, 1e-12));
    EXPECT_TRUE(oracle::close(as_matrix(forcing), s.forcing, 1e-12));
    EXPECT_TRUE(oracle::close(as_matrix(qdot), s.qdot, 1e-12));
    EXPECT_TRUE(oracle::close(as_matrix(udot), s.udot, 1e-12));
    EXPECT_TRUE(oracle::close(as_matrix(kinetic), as_matrix(s.kinetic_energy.value()), 1e-12));
    if (has_gravity<System>()) {
      EXPECT_TRUE(oracle::close(as_matrix(potential), as_matrix(s.potential_energy.value()), 1e-12));
    }

    const auto [inertia, active] = without_heap(balance, 0.0, x, p, r, as_vector(udot));
    const double heaviest =
        as_vector(active).cwiseAbs().maxCoeff() + as_matrix(forcing).cwiseAbs().maxCoeff();
    EXPECT_LE((as_vector(inertia) + as_vector(active)).cwiseAbs().maxCoeff(), 1e-12 * heaviest);

    MatrixXd full = MatrixXd::Identity(x.size(), x.size());
    full.bottomRightCorner(s.u.size(), s.u.size()) = as_matrix(mass_matrix);
    EXPECT_EQ(mass_matrix_full, full);
    EXPECT_EQ(forcing_full, stacked<System>(as_matrix(qdot), as_matrix(forcing)));
    EXPECT_EQ(rhs, stacked<System>(as_matrix(qdot), as_matrix(udot)));
  }
}

// All forces change the kinetic energy, all but gravity the whole.
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
    const auto power = [&](const auto& of) { return as_vector(of).dot(x.u()); };
    const double scale = as_vector(force).cwiseAbs().dot(x.u().cwiseAbs());
    EXPECT_NEAR(energy.kinetic, power(force), 1e-10 * scale);
    if (has_gravity<System>()) {
      const double other_power = power(without_heap(eom::active_forces, x, weightless, r));
      EXPECT_NEAR(energy.kinetic + energy.potential, other_power, 1e-10 * scale);
    }
  }
}

} // namespace check
