#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

namespace kanexpr::mechanics {

/// Replaces symbols in scalars and in vectors.
class vector_substitution {
public:
  constexpr explicit vector_substitution(graph& g) : images_(g) {}

  /// Registers a replacement; must be called before the first call of `in`.
  constexpr void replace(expression old, expression by) {
    images_.replace(old, by);
    is_empty_ = false;
  }

  constexpr expression in(expression e) { return is_empty_ ? e : images_.in(e); }
  constexpr vector in(const vector& v) {
    if (is_empty_) return v;
    vector out;
    for (const vector::part& p : v.parts)
      out.parts.push({p.frame, {in(p.value.x), in(p.value.y), in(p.value.z)}});
    return out;
  }

private:
  symbolic::substitution images_;
  bool is_empty_ = true;
};

/// Replaces the coordinate rates q̇ by the solutions of the kinematic differential equations.
class known_rates : public vector_substitution {
public:
  constexpr known_rates(const mechanism& m, const sequence<expression>& rates) : vector_substitution(*m.g) {
    for (int i = 0; i < m.coordinates.size(); ++i) replace(m.coordinate_rates[i], rates[i]);
  }
};

/// Removes the auxiliary speeds. They are zero at all times and are no longer needed once their partial
/// velocities, which bring into evidence forces that do no work, are known. Kane & Levinson (1985), section
/// 4.9.
class without_auxiliary_speeds : public vector_substitution {
public:
  constexpr explicit without_auxiliary_speeds(const mechanism& m) : vector_substitution(*m.g) {
    for (const expression& u : m.auxiliary_speeds) replace(u, m.zero());
  }
};

constexpr void drop_auxiliary_speeds(skeleton& s) {
  without_auxiliary_speeds drop(*s.model);
  for (vector& w : s.relative_angular_velocity) w = drop.in(w);
  for (station& n : s.stations) n.relative_velocity = drop.in(n.relative_velocity);
}

} // namespace kanexpr::mechanics
