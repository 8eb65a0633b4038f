#pragma once

#include <kanexpr/robots/cpp.hpp>
#include <kanexpr/robots/plan.hpp>

#include <string>
#include <utility>
#include <vector>

/// What the header of a robot declares of its joints besides the model.
namespace kanexpr::robots {

/// The limits of the joints with one coordinate, in the order of the joints.
inline std::string limits_of(const plan& p, const robot& source) {
  using named_list = std::pair<const char*, const std::vector<std::string>&>;
  std::vector<std::string> lower, upper, effort, velocity;
  for (const planned_joint& j : p.joints) {
    if (j.joint < 0 || !has_one_coordinate(j.kind)) continue;
    const joint_limits& l = entry(source.joints, j.joint).limits;
    lower.push_back(cpp::limit(l.lower)), upper.push_back(cpp::limit(l.upper));
    effort.push_back(cpp::limit(l.effort)), velocity.push_back(cpp::limit(l.velocity));
  }
  if (lower.empty()) return {};
  std::string lines =
      "\n/// The limits of the joints with one coordinate, in their order.\n"
      "struct limits {\n  static constexpr double no_limit = std::numeric_limits<double>::infinity();\n";
  for (const auto& [called, all] :
       {named_list("lower", lower), {"upper", upper}, {"effort", effort}, {"velocity", velocity}})
    lines += cpp::wrapped(std::string("  static constexpr double ") + called + "[]{", all) + "};\n";
  return lines + "};\n";
}

/// A function that returns the state at rest.
inline std::string at_rest_of(const plan& p) {
  std::string lines =
      "\n/// The state at rest in which all joint positions are zero.\ninline state<System> at_rest() {\n"
      "  state<System> x = state<System>::Zero();\n";
  for (const planned_joint& j : p.joints)
    if (j.kind == joint_kind::floating) lines += "  x[" + j.coordinates.back().called + "] = 1;\n";
  return lines + "  return x;\n}\n";
}

} // namespace kanexpr::robots
