#pragma once

#include <string_view>
#include <type_traits>

/// Types in the wrong place in a model.
namespace kanexpr::describe {

using std::string_view_literals::operator""sv; // compilers need not count the letters

inline constexpr std::string_view joint_out_of_place = "a joint; list it in joints<...>"sv;
/// A beam in place of a frame or a point.
inline constexpr std::string_view a_beam = "a beam; name a place on it by section<Self, Beam, place>"sv;

/// A point in place of something else.
inline constexpr std::string_view point_out_of_place = "a point; points need not be listed"sv;

/// Describes a type for a message about a misplaced type; empty if the type is not a word of a model.
template <class Type>
constexpr std::string_view describe_kind() {
  if constexpr (requires { Type::joint_description(); })
    return joint_out_of_place;
  else if constexpr (requires { Type::content(); })
    return "a body; list it in bodies<...>"sv;
  else if constexpr (requires { Type::orientation(); })
    return "a frame; frames need not be listed"sv;
  else if constexpr (requires { Type::place(); })
    return point_out_of_place;
  else if constexpr (requires { Type::load.what; })
    return "a load; list it in loads<...>"sv;
  else if constexpr (requires { Type::block.dynamics; })
    return "a block; list it in blocks<...>"sv;
  else if constexpr (requires { Type::word; })
    return "a word of the system"sv;
  else if constexpr (requires { Type::path.what; })
    return "a pathway; list a load along it, such as force_along<path, tension>"sv;
  else if constexpr (requires { Type::friction_law.kind; })
    return "a law of friction; list friction<joint or path, normal force, law>"sv;
  else if constexpr (requires { Type::contact_word; } || requires { &Type::lay_out; })
    return "an argument of contact<...>"sv;
  else if constexpr (requires { Type::joint_word; })
    return "an argument of a joint, such as pin<...>"sv;
  else if constexpr (
      requires { Type::tyre_word; } || requires { typename Type::center; } || requires { &Type::lie_under; })
    return "an argument of tyre<...>"sv;
  else
    return {};
}

struct anything {
  template <class Type>
  operator Type() const;
};

/// Whether a class is empty, has no bases, and is not a word of the library. No model contains such a class
/// on purpose, but after an error in a base clause, compilers continue with such a class. The user should
/// read that error; a message about its consequences would be misleading.
template <class Type>
constexpr bool is_unparsed() {
  if constexpr (requires { sizeof(Type); })
    return describe_kind<Type>().empty() && std::is_empty_v<Type> && std::is_aggregate_v<Type> &&
           !requires { Type{anything{}}; };
  else
    return false;
}

} // namespace kanexpr::describe
