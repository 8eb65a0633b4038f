#pragma once

namespace kanexpr::describe {

/// What an expression turns out to be.
enum class shape : unsigned char {
  nothing,
  scalar,
  vector,
  dyadic,
  equation,
  vanishing,  ///< zero_along
  kinematics, ///< kinematics_of
  simple,     ///< the kinematic differential equations that are q̇ = u
  foreign,    ///< it is none
};

} // namespace kanexpr::describe
