#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

#include <string_view>

/// The full inertial parameters of bodies; inertia forces and gravity are linear in them. A rigid body has a
/// mass, the first moments m·x, m·y and m·z, and moments and products of inertia with the sign of I = Σ m
/// (r·r E − r r), all about one point of the body and in the axes of its frame; a particle has only a mass.
/// Khalil & Dombre, Modeling, Identification and Control of Robots (2002), section 9.2.
namespace kanexpr::mechanics {

/// The names of the inertial parameters, in order.
inline constexpr const char* inertial_parameter_names[]{"m",   "m*x", "m*y", "m*z", "ixx",
                                                        "iyy", "izz", "ixy", "iyz", "izx"};

/// The number of inertial parameters of a body.
constexpr int inertial_parameters_of(const body& b) { return b.frame == none ? 1 : 10; }

/// The names of the inertial parameters of all bodies, in the order of the bodies: "m of Bob", "izz of Link".
constexpr sequence<name> names_of_inertial_parameters(const mechanism& m) {
  sequence<name> all;
  for (const body& b : m.bodies)
    for (int i = 0; i < inertial_parameters_of(b); ++i) {
      name called = inertial_parameter_names[i];
      called.append(" of ");
      called.append(b.called.view());
      all.push(called);
    }
  return all;
}

} // namespace kanexpr::mechanics
