#pragma once

#include <kanexpr/robots/robot.hpp>

#include <string>

namespace kanexpr::robots {

namespace detail {

/// Whether inertia·factor + shift·E has no negative principal value, by its minors.
inline bool is_semidefinite(const inertia_matrix& i, double factor, double shift) {
  const double xx = factor * i.xx + shift, yy = factor * i.yy + shift, zz = factor * i.zz + shift;
  const double xy = factor * i.xy, yz = factor * i.yz, zx = factor * i.zx;
  const double whole = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && yy * zz >= yz * yz && zz * xx >= zx * zx &&
         whole >= 0;
}

/// Scaled to a largest entry of 1.
inline inertia_matrix scaled(inertia_matrix i) {
  const double largest = i.largest();
  if (!(largest > 0)) return {};
  for (double* e : {&i.xx, &i.yy, &i.zz, &i.xy, &i.yz, &i.zx}) *e /= largest;
  return i;
}

} // namespace detail

/// Whether the moment about some axis is negative, by more than rounding.
inline bool is_indefinite(const inertia_matrix& i) {
  return !detail::is_semidefinite(detail::scaled(i), 1, 1e-9);
}

/// Whether it is nothing beside its mass, a radius of gyration below a thousandth of a millimetre: files hold
/// 1e-20 where a program computed zero.
inline bool is_rounding(const inertia_matrix& i, double mass) { return i.largest() <= 1e-12 * mass; }

/// Whether no distribution of mass has it: one principal moment is larger than the other two together, by
/// more than the digits of a published number.
inline bool is_of_no_body(const inertia_matrix& i) {
  const inertia_matrix s = detail::scaled(i);
  const double trace = s.xx + s.yy + s.zz;
  return !detail::is_semidefinite(s, -1, (0.5 + 1e-3) * trace);
}

/// What is wrong with an inertial, and what is only strange; both may be empty.
struct inertial_remarks {
  std::string mistake{}, note{};
};

/// Looks at an inertial, in which rounding errors become zero.
inline inertial_remarks remarks_on(inertial& of, const std::string& whose) {
  inertia_matrix& i = of.inertia;
  if (of.mass < 0) return {"the mass of " + whose + " is negative", {}};
  if (is_indefinite(i) && is_rounding(i, of.mass)) i = {};
  if (i.xx < 0 || i.yy < 0 || i.zz < 0) return {"a moment of inertia of " + whose + " is negative", {}};
  const std::string inertia = "the inertia of " + whose;
  if (!(of.mass > 0) && i.largest() > 0)
    return {{}, inertia + " comes without a mass, and is taken as it is"};
  if (is_indefinite(i)) // which what moves with the link may make up for
    return {{}, inertia + " is indefinite: about some axis its moment is negative"};
  if (is_of_no_body(i))
    return {{}, inertia + " is that of no body: one principal moment is larger than the other two together"};
  return {};
}

} // namespace kanexpr::robots
