#pragma once

#include <kanexpr/describe/what_it_is.hpp>

#include <type_traits>

namespace kanexpr::describe {

struct anything {
  template <class T>
  operator T() const;
};

/// Whether a class has neither bases nor members, and is not a word of the library. Nobody writes such an
/// entity or system, but it is what a compiler leaves of one with an error in its base clause. That error is
/// the one to read: a sentence about what follows from it would be false.
template <class T>
constexpr bool is_unparsed() {
  if constexpr (requires { sizeof(T); })
    return what_it_is<T>().empty() && std::is_empty_v<T> && std::is_aggregate_v<T> &&
           !requires { T{anything{}}; };
  else
    return false;
}

} // namespace kanexpr::describe
