#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

/// Mass matrices that are singular in every configuration.
namespace kanexpr::mechanics {

namespace detail {

constexpr double magnitude(double x) { return x < 0 ? -x : x; }

/// Returns the unknowns of a motion without kinetic energy, if a symmetric numeric matrix has one: the first
/// pivot that vanishes relative to its diagonal entry, and the unknowns that compensate it.
constexpr sequence<int> motion_without_energy(numbers a, double least) {
  const auto at = [&](int i, int j) -> double& { return a.entries[i * a.columns + j]; };
  for (int p = 0; p < a.rows; ++p) {
    const double whole = at(p, p);
    sequence<double> factor; // row p of L in M = L D Lᵀ
    for (int k = 0; k < p; ++k) {
      double entry = at(p, k);
      for (int j = 0; j < k; ++j) entry -= factor[j] * at(j, j) * at(k, j);
      factor.push(entry / at(k, k));
      at(p, p) -= factor[k] * entry;
    }
    for (int k = 0; k < p; ++k) at(p, k) = factor[k];
    if (!(magnitude(at(p, p)) <= least * magnitude(whole))) continue;
    sequence<double> share(p + 1, 0.0); // Lᵀ c = e
    share[p] = 1;
    sequence<int> moving;
    for (int k = p - 1; k >= 0; --k)
      for (int j = k + 1; j <= p; ++j) share[k] -= at(j, k) * share[j];
    for (int k = 0; k < p; ++k)
      if (share[k] * share[k] * magnitude(at(k, k)) > 1e-12 * magnitude(whole)) moving.push(k);
    moving.push(p);
    return moving;
  }
  return {};
}

/// Whether a mass matrix is clearly regular if symbols have smaller or larger magnitudes than assumed. A
/// model may specify too little about magnitudes: with an inertia of 1e-18, a mass of 1 and an arm of 1, for
/// example, a rotation and a translation are numerically the same motion.
constexpr bool is_regular_in_other_sizes(const mechanism& m, const symbolic::matrix& mass) {
  for (const double size : trial_sizes)
    for (const numbers& state : at_generic_states(mass, &m, size))
      if (motion_without_energy(state, clearly).empty()) return true;
  return false;
}

} // namespace detail

/// Whether every pivot of the elimination of a mass matrix is clearly different from zero, relative to its
/// diagonal entry, at a generic state. Constant pivots are not known; they count as zero.
constexpr bool are_clearly_regular(const mechanism& m, const sequence<symbolic::pivot>& pivots) {
  // more than the rounding errors of constants with ten digits, less than the pivots at the base of a chain
  constexpr double least = 1e-7;
  if (pivots.size() < m.speeds_of_motion()) return false;
  sequence<int> outputs;
  for (const symbolic::pivot& p : pivots) outputs.push(p.value.node()), outputs.push(p.entry.node());
  symbolic::evaluation value(*m.g, outputs);
  detail::generic_values generic(*m.g, value.live(), &m, 1);
  for (int attempt = 0; attempt < 3; ++attempt) {
    generic.draw();
    value.at([&](int id) { return generic[id]; });
    bool is_regular = true;
    for (int i = 0; i < outputs.size(); i += 2) // not if a value is NaN
      is_regular = is_regular &&
                   detail::magnitude(value[outputs[i]]) > least * detail::magnitude(value[outputs[i + 1]]);
    if (is_regular) return true;
  }
  return false;
}

/// Checks at generic states for speeds that move the same mass; `mass` is the mass matrix of the independent
/// speeds.
constexpr sentence check_same_mass(const mechanism& m, const partition& speeds,
                                   const symbolic::matrix& mass) {
  if (mass.rows < 2) return {}; // no other speed
  sequence<int> moving;
  for (const numbers& state : at_generic_states(mass, &m)) {
    moving = detail::motion_without_energy(state, base::vanishing_measure);
    if (moving.empty()) return {};
  }
  if (moving.empty() || detail::is_regular_in_other_sizes(m, mass)) return {};
  sequence<int> places;
  for (int i : moving) places.push(speeds.independent[i]);
  const bool kane = m.derived_by == method::kane;
  return sentence(
      {enumerated(m, kane ? m.speeds : m.coordinates, places, kane ? "speed" : "coordinate").view(),
       places.size() == 1 ? " moves no mass" : " move the same mass",
       " in any configuration: the mass matrix is numerically singular"});
}

} // namespace kanexpr::mechanics
