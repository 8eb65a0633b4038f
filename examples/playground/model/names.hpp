#pragma once

#include <kanexpr/base/library_words.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/runtime/building/builder_checks.hpp>
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
        "NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL MATH_ERRNO MATH_ERREXCEPT M_E M_LOG2E "
        "M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 System dot "
        "cross pi own kanexpr position_of velocity_of "
        "angular_velocity_of magnitude speeds coordinates parameters inputs bodies loads origin offset "
        "rotated particle rigid_body force torque gravity spring damper inertia speed coordinate "
        "parameter input inertial kinematics body_fixed space_fixed angular_velocity kinematics_of fixed_in "
        "force_between torque_between torsional_spring torsional_damper potential_energy zero_along "
        "configuration_constraints velocity_constraints dependent time_variable inertial_frame kane_system "
        "equations_of_motion sqrt sin cos tan asin acos atan exp log sinh cosh tanh abs sign atan2 hypot pow "
        "min max initial_state initial_parameters initial_inputs";
    return contains_word(reserved, name) || contains_word(kanexpr::exporting::words_of_cpp, name) ||
           contains_word(kanexpr::base::library_words::macros_of_the_library, name) ||
           name.starts_with("_") || name.find("__") != name.npos;
  }

  static bool contains_word(std::string_view words, std::string_view wanted) {
    using kanexpr::base::library_words::next_of;
    for (std::string_view word = next_of(words); !word.empty(); word = next_of(words))
      if (word == wanted) return true;
    return false;
  }

  std::map<std::string, entity> all_{};
};

} // namespace playground
