#pragma once

#include <kanexpr/mechanics/composite.hpp>
#include <kanexpr/mechanics/generalized_force.hpp>
#include <kanexpr/mechanics/skeleton_of.hpp>

namespace kanexpr::mechanics {

/// Kane's dynamical equations M u̇ = f, one for each generalized speed (Kane & Levinson 1985, section 6.1),
/// and the kinematic differential equations solved for q̇.
struct dynamical_equations {
  symbolic::matrix mass_matrix;
  sequence<expression> forcing;
  sequence<expression> coordinate_rates;
};

/// M; symmetric.
constexpr symbolic::matrix mass_matrix(const skeleton& s) { return mass_matrix_builder(s).run(); }

/// F_r: the generalized active forces.
constexpr sequence<expression> active_forces(const skeleton& s) {
  generalized_forces f(s);
  f.add_loads(true);
  return f.run();
}

/// F_r* at u̇ = 0: the part of the generalized inertia forces that is not −M u̇.
constexpr sequence<expression> inertia_bias(const skeleton& s) {
  generalized_forces f(s);
  motion k(s, speed_rates::zero);
  f.add_inertia_bias(k);
  return f.run();
}

/// F_r* = −M u̇ + (F_r* at u̇ = 0): the generalized inertia forces, with the symbols u̇.
constexpr sequence<expression> inertia_forces(const skeleton& s) {
  const symbolic::matrix m = mass_matrix(s);
  sequence<expression> force = inertia_bias(s);
  for (int i = 0; i < force.size(); ++i)
    for (int j = 0; j < force.size(); ++j) force[i] -= m(i, j) * s.model->speed_rates[j];
  return force;
}

/// f = F_r + F_r* at u̇ = 0, in one pass. Gravity on every body enters as an acceleration of the ground.
constexpr sequence<expression> forcing(const skeleton& s) {
  generalized_forces f(s);
  f.add_loads(false);
  motion k(s, speed_rates::zero);
  if (s.model->has_gravity) {
    vector up;
    up.subtract(s.model->gravity);
    k.accelerate_ground(up);
  }
  f.add_inertia_bias(k);
  return f.run();
}

} // namespace kanexpr::mechanics
