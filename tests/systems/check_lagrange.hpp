// Lagrange's equations of a system, compared with Kane's and with reference results.
#pragma once

#include "systems/check_constrained.hpp"

#include <kanexpr/assemble.hpp>

namespace check {

template <class System>
constexpr bool is_constrained = kanexpr::compiled::survey_of<System>.constraints > 0;

// Coordinates up to `reach`, speeds up to 2, in states that satisfy the constraints.
template <class System>
kanexpr::state<System> any_state(const kanexpr::parameter_values<System>& p,
                                 const kanexpr::input_values<System>& r, double reach, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  while (true) {
    kanexpr::state<System> x;
    for (double& q : x.q()) q = reach * any(random);
    for (double& u : x.u()) u = 2 * any(random);
    if constexpr (is_constrained<System>) {
      if (!kanexpr::assemble<System>(x, p, r) || x.norm() > 20) continue;
    }
    return x;
  }
}

// The second derivatives of the coordinates: the rates of q̇ along the motion.
template <class System>
VectorXd second_derivatives(const kanexpr::state<System>& x, const kanexpr::state<System>& rates,
                            const kanexpr::parameter_values<System>& p,
                            const kanexpr::input_values<System>& r) {
  using number = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  kanexpr::state<System, number> seeded;
  for (int i = 0; i < x.size(); ++i) seeded(i) = number(x(i), Eigen::Matrix<double, 1, 1>(rates(i)));
  const auto qdot = kanexpr::equations_of_motion<System>::qdot(seeded, p, r);
  return VectorXd::NullaryExpr(qdot.size(), [&](Eigen::Index i) { return qdot(i).derivatives()(0); });
}

// The same motion; coordinates that only Lagrange's system has do not matter, and constraints determine their
// rates.
template <class Lagrange, class Kane>
kanexpr::state<Lagrange> same_motion(const kanexpr::state<Kane>& x, const kanexpr::parameter_values<Kane>& p,
                                     const kanexpr::parameter_values<Lagrange>& p_lagrange,
                                     const kanexpr::input_values<Kane>& r) {
  kanexpr::state<Lagrange> out;
  const VectorXd qdot = kanexpr::equations_of_motion<Kane>::qdot(x, p, r);
  const auto own = names<Lagrange>(symbol_kind::coordinate), of_kane = names<Kane>(symbol_kind::coordinate);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto place = std::ranges::find(of_kane, own[i]) - of_kane.begin();
    if (place == static_cast<std::ptrdiff_t>(of_kane.size())) continue;
    out.q()(static_cast<Eigen::Index>(i)) = x.q()(place);
    out.u()(static_cast<Eigen::Index>(i)) = qdot(place);
  }
  if constexpr (is_constrained<Lagrange>) {
    EXPECT_TRUE(kanexpr::assemble<Lagrange>(out, p_lagrange, kanexpr::input_values<Lagrange>(r)));
  }
  return out;
}

// Entries of a vector over Lagrange's coordinates, in the order of Kane's.
template <class Lagrange, class Kane>
VectorXd in_kane_order(const VectorXd& values) {
  return pick(names<Kane>(symbol_kind::coordinate), names<Lagrange>(symbol_kind::coordinate), values);
}

// Both energies, the rates of the state, and the multipliers if there are any.
template <class System>
constexpr auto motion_of = [] {
  using eom = kanexpr::equations_of_motion<System>;
  constexpr auto free = eom::together(eom::kinetic_energy, eom::potential_energy, eom::rhs);
  if constexpr (is_constrained<System>)
    return eom::together(free, eom::multipliers);
  else
    return free;
}();

// Results that depend on the choice of speeds.
template <class System>
constexpr auto equations_of = [] {
  using eom = kanexpr::equations_of_motion<System>;
  return eom::together(eom::mass_matrix, eom::forcing, eom::active_forces, eom::inertia_forces);
}();

// q̈, energies and multipliers at random states, and the equations if Kane's speeds are the coordinate rates.
template <class Kane, class Lagrange, bool same_speeds>
void lagrange_against_kane(const numbers& values, double reach, double tolerance = 1e-12) {
  const auto p = parameters_by_name<Kane>(values);
  const auto p_lagrange = parameters_by_name<Lagrange>(values);
  ASSERT_EQ(names<Kane>(symbol_kind::input), names<Lagrange>(symbol_kind::input));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.5, 3);
  for (int repeat = 0; repeat < 30; ++repeat) {
    kanexpr::input_values<Kane> r;
    for (double& each : r) each = any(random);
    const kanexpr::input_values<Lagrange> same_r(r);
    const auto x = any_state<Kane>(p, r, reach, random);
    const auto y = same_motion<Lagrange, Kane>(x, p, p_lagrange, r);
    const auto found = without_heap(motion_of<Lagrange>, y, p_lagrange, same_r);
    const auto expected = without_heap(motion_of<Kane>, x, p, r);

    const VectorXd accelerations = std::get<2>(found).tail(kanexpr::state<Lagrange>::speeds);
    EXPECT_TRUE(oracle::close(in_kane_order<Lagrange, Kane>(accelerations),
                              second_derivatives<Kane>(x, std::get<2>(expected), p, r), tolerance));
    const double kinetic = std::get<0>(expected), potential = std::get<1>(expected);
    EXPECT_NEAR(std::get<0>(found), kinetic, 1e-12 * kinetic);
    if constexpr (kanexpr::state<Kane>::coordinates == kanexpr::state<Lagrange>::coordinates) {
      EXPECT_NEAR(std::get<1>(found), potential, 1e-12 * std::abs(potential));
    }
    if constexpr (is_constrained<Kane>) {
      EXPECT_TRUE(oracle::close(std::get<3>(found), std::get<3>(expected), tolerance));
    }
    if constexpr (same_speeds) {
      const VectorXd rates = VectorXd::NullaryExpr(x.u().size(), [&] { return any(random); });
      const auto [m, f, active, inertia] = equations_of<Lagrange>(0.0, y, p_lagrange, same_r, rates);
      const auto [m_kane, f_kane, active_kane, inertia_kane] = equations_of<Kane>(0.0, x, p, r, rates);
      EXPECT_TRUE(oracle::close(m, m_kane, tolerance));
      EXPECT_TRUE(oracle::close(f, f_kane, tolerance));
      EXPECT_TRUE(oracle::close(active, active_kane, tolerance));
      EXPECT_TRUE(oracle::close(inertia, inertia_kane, tolerance));
    }
  }
}

// For an oracle whose speeds are the rates of its coordinates, in the same order.
template <class Lagrange>
void lagrange_against_oracle(const std::string& name) {
  using eom = kanexpr::equations_of_motion<Lagrange>;
  const oracle::system reference = oracle::load(name);
  ASSERT_EQ(names<Lagrange>(symbol_kind::coordinate), reference.q);
  const auto p = parameters_by_name<Lagrange>(reference.parameters);
  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::state& s : reference.states) {
    ASSERT_TRUE(oracle::close(s.qdot, s.u, 1e-15));
    const auto y = stacked<Lagrange>(s.q, s.u);
    const auto r = inputs_by_name<Lagrange>(reference.r, s.r);
    const auto [mass_matrix, forcing, udot] =
        without_heap(eom::together(eom::mass_matrix, eom::forcing, eom::udot), y, p, r);
    EXPECT_TRUE(oracle::close(mass_matrix, s.mass_matrix, 1e-12));
    EXPECT_TRUE(oracle::close(forcing, s.forcing, 1e-12));
    EXPECT_TRUE(oracle::close(udot, s.udot, 1e-12));
  }
}

// For systems in which only gravity does work.
template <class Lagrange>
void keeps_its_energy(const numbers& values, double reach) {
  using eom = kanexpr::equations_of_motion<Lagrange>;
  const auto p = parameters_by_name<Lagrange>(values);
  std::mt19937 random(11);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto x = any_state<Lagrange>(p, eom::inputs::Zero(), reach, random);
    const energy_rates power = energy_rates_at<Lagrange>(x, p, eom::rhs(x, p, eom::inputs::Zero()));
    EXPECT_NEAR(power.kinetic, -power.potential, 1e-11 * (1 + std::abs(power.kinetic)));
  }
}

} // namespace check
