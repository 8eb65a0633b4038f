#pragma once

namespace kanexpr::describe {

/// The kind of an expression.
enum class shape : unsigned char {
  nothing,
  scalar,
  vector,
  dyadic,
  equation,
  vanishing,  ///< zero_along
  kinematics, ///< kinematics_of
  simple,     ///< the kinematic differential equations that are q̇ = u
  foreign,    ///< not an expression
};

} // namespace kanexpr::describe
