#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/wording.hpp>

/// A mass matrix that is singular in every configuration.
namespace kanexpr::mechanics {

namespace detail {

constexpr double magnitude(double x) { return x < 0 ? -x : x; }

/// The unknowns of a motion without energy, where a symmetric matrix of numbers has one: the first pivot that
/// vanishes beside its entry, with those that make up for it.
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

/// Whether a mass matrix is clearly regular where symbols are smaller or larger than they seem to be: a model
/// may say too little of that, and with 1e-18 as an inertia beside a mass and an arm of about 1 each, a turn
/// and a way are the same motion to all digits.
constexpr bool is_regular_in_other_sizes(const mechanism& m, const symbolic::matrix& mass) {
  for (const double size : other_sizes)
    for (const numbers& state : at_generic_states(mass, &m, size))
      if (motion_without_energy(state, clearly).empty()) return true;
  return false;
}

} // namespace detail

/// Found at generic states; `mass` is that of the independent speeds.
constexpr sentence check_same_mass(const mechanism& m, const partition& speeds,
                                   const symbolic::matrix& mass) {
  if (mass.rows < 2) return {}; // there is no other speed
  sequence<int> moving;
  for (const numbers& state : at_generic_states(mass, &m)) {
    moving = detail::motion_without_energy(state, vanishing_measure);
    if (moving.empty()) return {};
  }
  if (moving.empty() || detail::is_regular_in_other_sizes(m, mass)) return {};
  sequence<int> places;
  for (int i : moving) places.push(speeds.independent[i]);
  const bool kane = m.derived_by == method::kane;
  return sentence(
      {enumerated(m, kane ? m.speeds : m.coordinates, places, kane ? "speed" : "coordinate").view(),
       places.size() == 1 ? " moves no mass" : " move the same mass",
       " in any configuration: the mass matrix is singular, as far as numbers can tell"});
}

} // namespace kanexpr::mechanics
