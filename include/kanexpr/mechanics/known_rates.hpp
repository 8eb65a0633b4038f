#pragma once

#include <kanexpr/mechanics/mechanism.hpp>
#include <kanexpr/symbolic/substitute.hpp>

namespace kanexpr::mechanics {

/// Replaces the coordinate rates q̇ by what the kinematic differential equations say of them.
class known_rates {
public:
  constexpr known_rates(const mechanism& m, const sequence<expression>& rates) : rates_(*m.g) {
    for (int i = 0; i < m.coordinates.size(); ++i) rates_.replace(m.coordinate_rates[i], rates[i]);
  }

  constexpr expression in(expression e) { return rates_.in(e); }
  constexpr vector in(const vector& v) {
    vector out;
    for (const vector::part& p : v.parts)
      out.parts.push({p.frame, {rates_.in(p.value.x), rates_.in(p.value.y), rates_.in(p.value.z)}});
    return out;
  }

private:
  symbolic::substitution rates_;
};

} // namespace kanexpr::mechanics
