#pragma once

#include <kanexpr/describe/what_it_is.hpp>

#include <type_traits>

namespace kanexpr::describe {

struct anything {
  template <class Type>
  operator Type() const;
};

/// Whether a class has neither bases nor members and is not a word of the library. No model contains such an
/// entity or system on purpose, but after an error in a base clause, compilers continue with such a class.
/// The user should read that error; a sentence about its consequences would be misleading.
template <class Type>
constexpr bool is_unparsed() {
  if constexpr (requires { sizeof(Type); })
    return what_it_is<Type>().empty() && std::is_empty_v<Type> && std::is_aggregate_v<Type> &&
           !requires { Type{anything{}}; };
  else
    return false;
}

} // namespace kanexpr::describe
