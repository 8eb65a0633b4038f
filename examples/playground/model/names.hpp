#pragma once

#include <kanexpr/runtime/builder_checks.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace playground {

using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;

struct named_body {};
using entity = std::variant<kanexpr::symbolic::expression, frame_id, point_id, named_body>;

/// The names of a model. No two things share one, since C++ would not distinguish them.
class names {
public:
  /// Adds a name, or returns why it cannot be added.
  std::string add(const std::string& name, const entity& what) {
    if (is_reserved(name)) return name + " is a word of C++ or of kanexpr; choose another name";
    if (!all_.emplace(name, what).second) return "there are two things called " + name;
    return "";
  }

  /// Returns null if there is no thing of this kind with this name.
  template <class Kind>
  const Kind* find(const std::string& name) const {
    const auto found = all_.find(name);
    return found == all_.end() ? nullptr : std::get_if<Kind>(&found->second);
  }
  bool contains(const std::string& name) const { return all_.contains(name); }

private:
  /// Words that would mean something else in a file of C++ types.
  static bool is_reserved(const std::string& name) {
    static constexpr std::string_view reserved =
        " and auto bool break case catch char class concept const continue default delete do double else "
        "enum explicit export extern false float for friend goto if inline int long mutable new not "
        "operator or private protected public register requires return short signed sizeof static "
        "struct switch template this throw true try typedef typeid typename union unsigned using "
        "virtual void volatile while xor System dot cross pi own kanexpr position_of velocity_of "
        "angular_velocity_of magnitude speeds coordinates parameters inputs bodies loads origin offset "
        "rotated particle rigid_body force torque gravity spring damper inertia speed coordinate "
        "parameter input inertial kinematics body_fixed space_fixed angular_velocity kinematics_of fixed_in "
        "force_between torque_between torsional_spring torsional_damper potential_energy zero_along "
        "configuration_constraints velocity_constraints dependent time_variable inertial_frame kane_system "
        "equations_of_motion sqrt sin cos tan asin acos atan exp log sinh cosh tanh abs sign atan2 hypot pow "
        "min max initial_state initial_parameters initial_inputs ";
    return reserved.find(' ' + name + ' ') != reserved.npos || name.starts_with("_") ||
           name.find("__") != name.npos;
  }

  std::map<std::string, entity> all_{};
};

} // namespace playground
