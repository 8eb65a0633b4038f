#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/skeleton_of.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// For each speed, the coordinate whose rate it is; an error message if some speed is not a coordinate rate.
struct speeds_as_rates {
  sentence mistake{};
  sequence<int> coordinate{};
};

constexpr speeds_as_rates coordinates_of_speeds(const skeleton& s) {
  const mechanism& m = *s.model;
  speeds_as_rates found;
  for (int i = 0; i < m.speeds.size(); ++i) {
    int own = none;
    for (int j = 0; j < m.coordinates.size(); ++j)
      if (s.coordinate_rates[j] == m.speeds[i]) own = j;
    if (own == none && !found.mistake)
      found.mistake = sentence({"the Coriolis matrix requires every speed to be a coordinate rate; ",
                                speed_called(m, called(m, m.speeds[i])).view(), " is not one"});
    found.coordinate.push(own);
  }
  return found;
}

/// Returns C, where C u is the part of M u̇ − f that is quadratic in the speeds u = q̇, from Christoffel
/// symbols of the first kind, so that Ṁ − 2C is skew-symmetric: C = (Ṁ + J − Jᵀ)/2, where J is the derivative
/// of the momenta M u with respect to q (Siciliano et al., Robotics: Modelling, Planning and Control, section
/// 7.2.1).
constexpr symbolic::matrix coriolis_matrix(const mechanism& m, const sequence<int>& coordinate,
                                           const symbolic::matrix& mass,
                                           const sequence<expression>& momenta) {
  const int n = mass.rows;
  sequence<expression> q;
  for (int j : coordinate) q.push(m.coordinates[j]);
  const symbolic::matrix by_q = symbolic::jacobian(*m.g, momenta, q);
  symbolic::matrix c(*m.g, n, n);
  symbolic::differentiation change(*m.g);
  for (int j = 0; j < n; ++j) change.set_rate(q[j], m.speeds[j]);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      const expression rate = change.of(mass(i, j)), turned = by_q(i, j) - by_q(j, i);
      c(i, j) = (rate + turned) / 2;
      c(j, i) = (rate - turned) / 2;
    }
  return c;
}

} // namespace kanexpr::mechanics
