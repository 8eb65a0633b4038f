#pragma once

#include <kanexpr/robots/robot.hpp>

#include <string>

namespace kanexpr::robots {

namespace detail {

/// Whether factor·inertia + shift·E is positive semidefinite, judged by its principal minors.
inline bool is_semidefinite(const inertia_matrix& i, double factor, double shift) {
  const double xx = factor * i.xx + shift, yy = factor * i.yy + shift, zz = factor * i.zz + shift;
  const double xy = factor * i.xy, yz = factor * i.yz, zx = factor * i.zx;
  const double whole = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && yy * zz >= yz * yz && zz * xx >= zx * zx &&
         whole >= 0;
}

/// The inertia scaled so that its largest entry is 1.
inline inertia_matrix scaled(inertia_matrix i) {
  const double largest = i.largest();
  if (!(largest > 0)) return {};
  for (double* e : {&i.xx, &i.yy, &i.zz, &i.xy, &i.yz, &i.zx}) *e /= largest;
  return i;
}

} // namespace detail

/// Whether the moment of inertia about some axis is negative by more than rounding.
inline bool is_indefinite(const inertia_matrix& i) {
  return !detail::is_semidefinite(detail::scaled(i), 1, 1e-9);
}

/// Whether the inertia is negligible compared with the mass (a radius of gyration below one micrometer):
/// files contain 1e-20 where a program computed zero.
inline bool is_rounding(const inertia_matrix& i, double mass) { return i.largest() <= 1e-12 * mass; }

/// Whether no mass distribution can have this inertia because one principal moment exceeds the sum of the
/// other two by more than the rounding of published numbers.
inline bool is_of_no_body(const inertia_matrix& i) {
  const inertia_matrix s = detail::scaled(i);
  const double trace = s.xx + s.yy + s.zz;
  return !detail::is_semidefinite(s, -1, (0.5 + 1e-3) * trace);
}

/// A mistake in the inertial properties of a link, and a note about something unusual; both may be empty.
struct inertial_remarks {
  std::string mistake{}, note{};
};

/// Checks the inertial properties of a link; sets an inertia that consists of rounding errors to zero.
inline inertial_remarks remarks_on(inertial& of, const std::string& whose) {
  inertia_matrix& i = of.inertia;
  if (of.mass < 0) return {"the mass of " + whose + " is negative", {}};
  if (is_indefinite(i) && is_rounding(i, of.mass)) i = {};
  if (i.xx < 0 || i.yy < 0 || i.zz < 0) return {"a moment of inertia of " + whose + " is negative", {}};
  const std::string inertia = "the inertia of " + whose;
  if (!(of.mass > 0) && i.largest() > 0)
    return {{}, inertia + " is given without a mass and is used as written"};
  if (is_indefinite(i)) // links fixed to this one may compensate for it
    return {{}, inertia + " is indefinite: its moment about some axis is negative"};
  if (is_of_no_body(i))
    return {{}, inertia + " is not physical: one principal moment exceeds the sum of the other two"};
  return {};
}

} // namespace kanexpr::robots
