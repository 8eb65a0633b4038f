#pragma once

#include <string_view>

namespace kanexpr::describe {

inline constexpr std::string_view joint_out_of_place = "a joint; list it in joints<...>";

/// Describes a type for a sentence about a type in the wrong place; empty if it is not a word of a model.
template <class Type>
constexpr std::string_view what_it_is() {
  if constexpr (requires { Type::joint_told(); })
    return joint_out_of_place;
  else if constexpr (requires { Type::content(); })
    return "a body; list it in bodies<...>";
  else if constexpr (requires { Type::orientation(); })
    return "a frame; frames need not be listed";
  else if constexpr (requires { Type::place(); })
    return "a point; points need not be listed";
  else if constexpr (requires { Type::load.what; })
    return "a load; list it in loads<...>";
  else if constexpr (requires { Type::word; })
    return "a word of the system";
  else
    return {};
}

} // namespace kanexpr::describe
