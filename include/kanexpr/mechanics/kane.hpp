#pragma once

#include <kanexpr/mechanics/composite.hpp>
#include <kanexpr/mechanics/generalized_force.hpp>
#include <kanexpr/mechanics/skeleton_of.hpp>

/// Kane's dynamical equations M u̇ = f, one for each way of moving: for each generalized speed, then for each
/// auxiliary speed (Kane & Levinson 1985, section 6.1), as if no constraint bound the speeds.
namespace kanexpr::mechanics {

/// M; symmetric.
constexpr symbolic::matrix mass_matrix(const skeleton& s) { return mass_matrix_builder(s).run(); }

/// F_r: the generalized active forces.
constexpr sequence<expression> active_forces(const skeleton& s) {
  generalized_forces f(s);
  f.add_loads(true);
  return f.run();
}

/// All motion at u̇ = 0, in which the ground falls upwards in place of gravity on every body.
constexpr motion bias_motion(const skeleton& s) {
  motion k(s);
  if (s.model->has_gravity) k.accelerate_ground(-s.model->gravity);
  return k;
}

/// F_r* at u̇ = 0: the part of the generalized inertia forces that is not −M u̇.
constexpr sequence<expression> inertia_bias(const skeleton& s) {
  generalized_forces f(s);
  motion k(s);
  f.add_inertia_bias(k);
  f.add_changes_of_mass(k);
  return f.run();
}

/// f = F_r + F_r* at u̇ = 0, in one pass. Gravity on every body enters as an acceleration of the ground.
constexpr sequence<expression> forcing(const skeleton& s) {
  generalized_forces f(s);
  f.add_loads(false);
  motion k = bias_motion(s);
  f.add_inertia_bias(k);
  f.add_changes_of_mass(k);
  return f.run();
}

} // namespace kanexpr::mechanics
