#pragma once

#include <kanexpr/robots/robot.hpp>

#include <optional>

namespace kanexpr::robots {

enum class base_kind : unsigned char {
  fixed,    ///< the root is fixed in the ground
  floating, ///< it moves by position and unit quaternion
};

enum class binding : unsigned char {
  numbers,
  parameters, ///< masses, mass centres, inertias, dampings and gravity have symbols; lengths stay numbers
};

/// What is made of a robot.
struct model_options {
  base_kind base = base_kind::fixed;
  binding bind = binding::numbers;
  std::optional<double> gravity{}; ///< against the z axis of the root, m/s²; else that of the robot, or 9.81
  bool damping = true;             ///< the torques −c q̇ of the file
  bool friction = false;           ///< the torques −f sign q̇ of the file, which have no derivative at rest
};

/// The acceleration of free fall of a model, in the axes of its root.
inline vector3 gravity_of(const robot& r, const model_options& options) {
  if (options.gravity || !r.gravity) return {0, 0, -options.gravity.value_or(9.81)};
  return *r.gravity;
}

/// What it is a multiple of, where its magnitude is a parameter.
inline vector3 direction_of_gravity(const vector3& g) {
  return is_zero(g) ? vector3{0, 0, -1} : direction_of(g, 0);
}

} // namespace kanexpr::robots
