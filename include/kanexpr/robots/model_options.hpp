#pragma once

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
  double gravity = 9.81; ///< against the z axis of the root, m/s²
  bool damping = true;   ///< the torques −c q̇ of the file
  bool friction = false; ///< the torques −f sign q̇ of the file, which have no derivative at rest
};

} // namespace kanexpr::robots
