#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/robots/robot.hpp>

#include <string>
#include <vector>

namespace kanexpr::robots {

/// A robot, or why a file has none: "line 12 of arm.urdf: the mass of link elbow is negative".
struct [[nodiscard]] read_robot : outcome {
  using outcome::outcome;

  robots::robot robot{};
  /// What was left out, or is strange: "line 80 of arm.urdf: the inertia of link hand is that of no body: …".
  std::vector<std::string> notes{};
};

} // namespace kanexpr::robots
