#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/checks/check_mass.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/dynamics/dynamics.hpp>
#include <kanexpr/mechanics/dynamics/positive_mass.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

namespace kanexpr::mechanics {

/// What the checks of a mass matrix found.
struct checked_mass {
  sentence mistake{};
  /// Whether the matrix is regular in every configuration. If lengths are unbounded, a pivot may consist
  /// entirely of rounding errors.
  bool is_regular = false;
};

/// Checks the mass matrix of the independent speeds.
constexpr checked_mass check_regular_mass(const skeleton& s, const partition& speeds,
                                          const symbolic::matrix& mass, bool has_lagrangian) {
  const mechanism& m = *s.model;
  sequence<expression> diagonal;
  for (int i = 0; i < mass.rows; ++i) diagonal.push(mass(i, i));
  checked_mass found{check_mass_matrix(m, speeds, diagonal)};
  const bool is_positive = !has_lagrangian && positive_energy_proof(s).is_positive();
  if (!found.mistake && !is_positive) found.mistake = check_same_mass(m, speeds, mass);
  found.is_regular = is_positive && symbolic::depend_only_on_angles(*m.g, symbolic::nodes_of(mass.entries));
  return found;
}

/// Checks a mass matrix that the solution does not need by the pivots of this solution. It is formed only if
/// they leave doubt.
constexpr checked_mass check_regular_pivots(const skeleton& s, const partition& speeds, dynamics& solved) {
  const mechanism& m = *s.model;
  const bool is_positive = positive_energy_proof(s).is_positive();
  sequence<int> values;
  for (const symbolic::pivot& p : solved.pivots_without_mass()) values.push(p.value.node());
  checked_mass found{{}, is_positive && symbolic::depend_only_on_angles(*m.g, values)};
  if (found.is_regular) return found;
  found.mistake = check_mass_matrix(m, speeds, solved.compare_pivots_with_diagonal());
  if (!found.mistake && !is_positive && !are_clearly_regular(m, solved.pivots_without_mass()))
    found.mistake = check_same_mass(m, speeds, solved.mass());
  return found;
}

} // namespace kanexpr::mechanics
