#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/composite.hpp>
#include <kanexpr/mechanics/dynamics/generalized_force.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/skeleton_of.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Kane's dynamical equations M u̇ = f without constraints, one for each generalized speed, followed by those
/// of the auxiliary speeds (Kane & Levinson 1985, section 6.1).
namespace kanexpr::mechanics {

/// M; symmetric.
constexpr symbolic::matrix mass_matrix(const skeleton& s) { return mass_matrix_builder(s).run(); }

/// The diagonal of M of a system without flexible bodies, one entry for each speed.
constexpr sequence<expression> diagonal_of_mass_matrix(const skeleton& s) {
  mass_matrix_builder builder(s, mass_matrix_builder::extent::diagonal);
  const symbolic::matrix& formed = builder.run();
  sequence<expression> diagonal;
  for (int i = 0; i < s.model->speeds.size(); ++i) diagonal.push(formed(i, i));
  return diagonal;
}

/// F_r: the generalized active forces.
constexpr sequence<expression> active_forces(const skeleton& s, const loads& acting) {
  generalized_forces f(s);
  f.add_loads(acting, true);
  return f.run();
}

/// F_r of gravity only.
constexpr sequence<expression> forces_of_gravity(const skeleton& s, const loads& acting) {
  generalized_forces f(s);
  f.add_gravity(acting);
  return f.run();
}

/// The motion in which an upward acceleration of the ground replaces gravity; without rates of the speeds, it
/// is evaluated at u̇ = 0.
constexpr motion motion_on_accelerated_ground(const skeleton& s, const loads& acting,
                                              const sequence<expression>& udot = {}) {
  motion k(s, udot);
  if (acting.has_gravity) k.accelerate_ground(-acting.gravity);
  return k;
}

/// F_r of all loads except gravity.
constexpr sequence<expression> forces_of_loads(const skeleton& s, const loads& acting) {
  generalized_forces f(s);
  f.add_loads(acting, false);
  return f.run();
}

/// F_r* of a motion on ground that accelerates in place of gravity: inverse dynamics, linear in u̇.
constexpr sequence<expression> inertia_forces(const skeleton& s, motion& k) {
  generalized_forces f(s);
  f.add_inertia(k);
  f.add_changes_of_mass(k);
  return f.run();
}

/// F_r* at u̇ = 0: the part of the generalized inertia forces other than −M u̇.
constexpr sequence<expression> inertia_bias(const skeleton& s) {
  motion k(s);
  return inertia_forces(s, k);
}

/// F_r + F_r* in one pass; f at u̇ = 0 if no rates are given. Gravity enters as an acceleration of the
/// ground.
constexpr sequence<expression> forcing(const skeleton& s, const loads& acting,
                                       const sequence<expression>& udot = {}) {
  generalized_forces f(s);
  f.add_loads(acting, false);
  motion k = motion_on_accelerated_ground(s, acting, udot);
  f.add_inertia(k);
  f.add_changes_of_mass(k);
  return f.run();
}

} // namespace kanexpr::mechanics
