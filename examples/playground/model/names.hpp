#pragma once

#include <kanexpr/runtime/builder_checks.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
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
  static bool is_reserved(std::string_view name) {
    static constexpr std::string_view reserved[]{"and",
                                                 "auto",
                                                 "bool",
                                                 "break",
                                                 "case",
                                                 "catch",
                                                 "char",
                                                 "class",
                                                 "concept",
                                                 "const",
                                                 "continue",
                                                 "default",
                                                 "delete",
                                                 "do",
                                                 "double",
                                                 "else",
                                                 "enum",
                                                 "explicit",
                                                 "export",
                                                 "extern",
                                                 "false",
                                                 "float",
                                                 "for",
                                                 "friend",
                                                 "goto",
                                                 "if",
                                                 "inline",
                                                 "int",
                                                 "long",
                                                 "mutable",
                                                 "new",
                                                 "not",
                                                 "operator",
                                                 "or",
                                                 "private",
                                                 "protected",
                                                 "public",
                                                 "register",
                                                 "requires",
                                                 "return",
                                                 "short",
                                                 "signed",
                                                 "sizeof",
                                                 "static",
                                                 "struct",
                                                 "switch",
                                                 "template",
                                                 "this",
                                                 "throw",
                                                 "true",
                                                 "try",
                                                 "typedef",
                                                 "typeid",
                                                 "typename",
                                                 "union",
                                                 "unsigned",
                                                 "using",
                                                 "virtual",
                                                 "void",
                                                 "volatile",
                                                 "while",
                                                 "xor",
                                                 "System",
                                                 "dot",
                                                 "cross",
                                                 "pi",
                                                 "own",
                                                 "kanexpr",
                                                 "position_of",
                                                 "velocity_of",
                                                 "angular_velocity_of",
                                                 "magnitude",
                                                 "speeds",
                                                 "coordinates",
                                                 "parameters",
                                                 "inputs",
                                                 "bodies",
                                                 "loads",
                                                 "origin",
                                                 "offset",
                                                 "rotated",
                                                 "particle",
                                                 "rigid_body",
                                                 "force",
                                                 "torque",
                                                 "gravity",
                                                 "spring",
                                                 "damper",
                                                 "inertia",
                                                 "speed",
                                                 "coordinate",
                                                 "parameter",
                                                 "input",
                                                 "inertial",
                                                 "kinematics",
                                                 "initial_state",
                                                 "initial_parameters",
                                                 "initial_inputs"};
    return std::ranges::find(reserved, name) != std::end(reserved) || name.starts_with("_") ||
           name.find("__") != name.npos;
  }

  std::map<std::string, entity> all_{};
};

} // namespace playground
