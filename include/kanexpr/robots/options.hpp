#pragma once

#include <kanexpr/robots/robot.hpp>

#include <optional>
#include <string>

namespace kanexpr::robots {

/// Options for reading a file.
struct reading_options {
  /// The tolerance in radians within which angles are rounded to multiples of π/4 and directions to basis
  /// vectors: files contain numbers such as 1.5707 and 3.1416, whose cosine or sine is not exactly zero. 0
  /// keeps angles as written.
  double right_angles = 1e-4;
  /// Whether mimic joints follow their leaders; if not, they move independently.
  bool mimic = true;
};

/// How the root of a robot is connected to the ground.
enum class base_kind : unsigned char {
  fixed,    ///< the root is fixed to the ground
  floating, ///< the root moves freely, described by its position and a unit quaternion
};

enum class binding : unsigned char {
  numbers,
  parameters, ///< masses, mass centers, inertias, dampings and gravity are symbols; lengths remain numbers
};

/// Stops at the limits of joints: see `stop` for their law.
struct limit_stops {
  double turning = 1e3;  ///< stiffness, N m/rad
  double sliding = 1e5;  ///< stiffness, N/m
  double damping = 1;    ///< of Hunt and Crossley, s/rad or s/m
  double width = 1e-3;   ///< over which the contact is rounded, rad or m
  double no_limit = 1e9; ///< in place of an infinite limit
};

/// The dry friction f of joints, −f q̇/√(q̇² + vₛ²): the slip speeds vₛ below which it decreases to zero.
struct dry_friction {
  double turning = 1e-2; ///< slip speed, rad/s
  double sliding = 1e-3; ///< slip speed, m/s
};

/// Options for the model of a robot.
struct model_options {
  base_kind base = base_kind::fixed;
  binding bind = binding::numbers;
  std::optional<double> gravity{}; ///< along −z of the root, m/s²; default: the gravity of the robot, or 9.81
  bool damping = true;             ///< whether to apply the torques −c q̇ of the file
  std::optional<dry_friction> friction{}; ///< whether to apply the dry friction of the file, and its law
  std::optional<limit_stops> stops{};     ///< whether the limits of joints are stops, and their law
  std::string formulation{}; ///< in a header: the word `formulation<…>` of the system; empty if it has none
};

/// The gravitational acceleration of a model, in the axes of its root.
inline vector3 gravity_of(const robot& r, const model_options& options) {
  if (options.gravity || !r.gravity) return {0, 0, -options.gravity.value_or(9.81)};
  return *r.gravity;
}

/// The direction of gravity when its magnitude is a parameter.
inline vector3 direction_of_gravity(const vector3& g) {
  return is_zero(g) ? vector3{0, 0, -1} : direction_of(g, 0);
}

} // namespace kanexpr::robots
