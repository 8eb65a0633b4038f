#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Time derivatives of scalars and orientations.
namespace kanexpr::mechanics {

/// The time derivative of scalars for given rates of the coordinates and speeds; a speed without a rate is
/// treated as constant.
constexpr symbolic::differentiation time_derivative(const mechanism& m, const sequence<expression>& qdot,
                                                    const sequence<expression>& udot = {}) {
  symbolic::differentiation d(*m.g);
  d.set_rate(m.time, m.one());
  for (const prescribed_rate& p : m.prescribed_rates) d.set_rate(p.quantity, p.rate);
  for (int i = 0; i < m.coordinates.size(); ++i) d.set_rate(m.coordinates[i], qdot[i]);
  for (int i = 0; i < udot.size(); ++i) d.set_rate(m.speeds[i], udot[i]);
  return d;
}

/// The angular velocity of a frame in its parent, derived from its orientation; `along_time` provides the
/// rates.
constexpr vector relative_angular_velocity(const mechanism& m, int place,
                                           symbolic::differentiation& along_time) {
  const frame& f = m.frames[place];
  vector w;
  switch (f.kind) {
  case orientation::inertial: break;
  case orientation::about_basis: w.add(f.parent, along_time.of(f.angle) * unit(*m.g, f.axis)); break;
  case orientation::about_axis: w.add(f.parent, along_time.of(f.angle) * f.direction); break;
  case orientation::matrix: { // ω in the frame's own axes from RᵀṘ
    components sum(*m.g);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        sum[i] += f.to_parent(k, l) * along_time.of(f.to_parent(k, j));
      }
    w.add(place, sum);
    break;
  }
  }
  return w;
}

} // namespace kanexpr::mechanics
