#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// The inertia of a body and of the bodies outward, which are free to move relative to it, about a point of
/// the body: an acceleration a of the point and an angular acceleration α take the force M a + H α and the
/// moment Hᵀ a + I α. Featherstone (2008), section 7.1.
struct articulated_mass {
  symmetric mass{};
  matrix3 coupling{}; ///< H
  symmetric inertia{};

  constexpr articulated_mass() = default;
  constexpr explicit articulated_mass(graph& g) : mass(g), coupling(g), inertia(g) {}

  /// The inertia of a rigid body: M = m E and H = −[h]×.
  constexpr explicit articulated_mass(const rigid_mass& rigid)
      : mass(rigid.mass.owner()), coupling(rigid.mass.owner()), inertia(rigid.inertia) {
    const components &h = rigid.first_moment, opposite = -h;
    mass.xx = mass.yy = mass.zz = rigid.mass;
    coupling.row[0] = {mass.xy, h.z, opposite.y};
    coupling.row[1] = {opposite.z, mass.xy, h.x};
    coupling.row[2] = {h.y, opposite.x, mass.xy};
  }

  constexpr articulated_mass& operator+=(const articulated_mass& other) {
    mass = mass + other.mass;
    for (int i = 0; i < 3; ++i) coupling.row[i] += other.coupling.row[i];
    inertia = inertia + other.inertia;
    return *this;
  }
};

/// The inertia about c, moved to p, where c is at p + r: H' = H − M [r]× and I' = I + [r]× H' + ([r]× H)ᵀ.
constexpr articulated_mass shifted(const articulated_mass& at, const components& r) {
  articulated_mass to = at;
  for (int i = 0; i < 3; ++i) to.coupling.row[i] += cross(r, {at.mass(i, 0), at.mass(i, 1), at.mass(i, 2)});
  const matrix3 before = transpose(at.coupling), after = transpose(to.coupling);
  for (int i = 0; i < 3; ++i) {
    to.inertia(i, i) += cross(r, before.row[i] + after.row[i])[i];
    const components of_before = cross(r, before.row[i]);
    for (int j = i + 1; j < 3; ++j) {
      const components of_after = cross(r, after.row[j]);
      to.inertia(i, j) += of_before[j] + of_after[i];
    }
  }
  return to;
}

/// The inertia in the axes at the end of a path.
constexpr articulated_mass turned(const path& way, const articulated_mass& m) {
  articulated_mass to;
  to.mass = m.mass;
  const bool is_isotropic = m.mass.xx == m.mass.yy && m.mass.yy == m.mass.zz && m.mass.xy.is_zero() &&
                            m.mass.yz.is_zero() && m.mass.zx.is_zero();
  if (!is_isotropic) to.mass = way.turn(m.mass);
  matrix3 half;
  for (int i = 0; i < 3; ++i) half.row[i] = way.turn(m.coupling.row[i]);
  half = transpose(half);
  for (int j = 0; j < 3; ++j) half.row[j] = way.turn(half.row[j]);
  to.coupling = transpose(half);
  to.inertia = way.turn(m.inertia);
  return to;
}

} // namespace kanexpr::mechanics
