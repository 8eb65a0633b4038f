#pragma once

#include <type_traits>

/// Systems whose base clause did not parse.
namespace kanexpr::compiled {

struct anything {
  template <class T>
  operator T() const;
};

/// Whether a class has neither bases nor members: nobody writes such a system, but it is what a compiler leaves
/// of one with an error in its base clause. That error is the one to read, so no sentence is told about it.
template <class System>
inline constexpr bool is_unparsed =
    std::is_empty_v<System> && std::is_aggregate_v<System> && !requires { System{anything{}}; };

/// Compilers look at this attribute only where there was no error before.
template <class System>
[[gnu::error("a system is derived from kane_system<...> or lagrange_system<...>, and this one from nothing")]] //
void derived_from_nothing() noexcept;

/// Where a system is used.
template <class System>
[[gnu::always_inline]] inline void check_derived() noexcept {
  if constexpr (is_unparsed<System>) derived_from_nothing<System>();
}

} // namespace kanexpr::compiled
