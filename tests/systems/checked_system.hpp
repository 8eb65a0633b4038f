// The common parts of the checks of whole systems.
#pragma once

#include "no_heap.hpp"
#include "oracles.hpp"

#include <kanexpr/kanexpr.hpp>

#include <unsupported/Eigen/AutoDiff>

#include <random>

namespace check {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A call that must not use the heap: the program aborts if it does.
template <class Function, class... Arguments>
auto without_heap(Function function, const Arguments&... arguments) {
  no_heap::guard guard;
  return function(arguments...);
}

template <class System>
std::vector<std::string> names(kanexpr::symbolic::symbol_kind kind) {
  const auto& survey = kanexpr::compiled::survey_of<System>;
  std::vector<std::string> all;
  for (int i = 0; i < survey.count_of(kind); ++i)
    all.emplace_back(survey.names[survey.first_of(kind) + i].view());
  return all;
}

template <class System>
kanexpr::state<System> stacked(const VectorXd& q, const VectorXd& u) {
  kanexpr::state<System> x;
  x << q, u;
  return x;
}

template <class System>
constexpr bool has_gravity() {
  for (int i = 0; i < System::record.loads.size; ++i)
    if (System::record.loads[i].what == kanexpr::describe::load_word::gravity) return true;
  return false;
}

// A state near a given one with new speeds; the states of an oracle are not close to singular positions.
template <class System>
kanexpr::state<System> disturbed(kanexpr::state<System> x, std::mt19937& random) {
  std::uniform_real_distribution<double> little(-0.1, 0.1), much(-2, 2);
  for (double& angle : x.q()) angle += little(random);
  for (double& rate : x.u()) rate = much(random);
  return x;
}

struct energy_rates {
  double kinetic, potential;
};

// Both energies as numbers that carry derivatives; row i of `seeds` contains those of x(i).
template <class System, int derivatives>
auto energies_with(const Eigen::Matrix<double, kanexpr::state<System>::RowsAtCompileTime, derivatives>& seeds,
                   const kanexpr::state<System>& x, const kanexpr::parameter_values<System>& p) {
  using eom = kanexpr::equations_of_motion<System>;
  using number = Eigen::AutoDiffScalar<Eigen::Matrix<double, derivatives, 1>>;
  kanexpr::state<System, number> seeded;
  for (int i = 0; i < x.size(); ++i) seeded(i) = number(x(i), seeds.row(i).transpose());
  return without_heap(eom::together(eom::kinetic_energy, eom::potential_energy), seeded, p);
}

// The rates of both energies for given rates of the state, from their gradients.
template <class System>
energy_rates energy_rates_at(const kanexpr::state<System>& x, const kanexpr::parameter_values<System>& p,
                             const kanexpr::state<System>& rates) {
  constexpr int n = kanexpr::state<System>::RowsAtCompileTime;
  const Eigen::Matrix<double, n, n> all = Eigen::Matrix<double, n, n>::Identity();
  const auto [kinetic, potential] = energies_with<System, n>(all, x, p);
  return {kinetic.derivatives().dot(rates), potential.derivatives().dot(rates)};
}

// The same from one derivative with respect to time, because a gradient would take too long to compile.
template <class System>
energy_rates energy_rates_along(const kanexpr::state<System>& x, const kanexpr::state<System>& rates) {
  const auto [kinetic, potential] = energies_with<System, 1>(rates, x, {});
  return {kinetic.derivatives()(0), potential.derivatives()(0)};
}

} // namespace check
