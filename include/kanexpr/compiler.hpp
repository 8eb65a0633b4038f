#pragma once

/// Checks the compiler and its options. Compilation must stop after an error message. The error itself does
/// not stop it, but a missing header or an endless recursion of class templates does.

#if __cplusplus < 202002L
#error "kanexpr requires C++20: compile with -std=c++20 or a later standard"
#include <nothing_without_c++20>
#define constexpr // otherwise clang++ continues silently and crashes at a destructor
#elif defined __GNUC__ && !defined __clang__ && __GNUC__ < 12
#error "kanexpr requires g++ 12 or later, or clang"
#include <nothing_for_this_compiler>
#elif defined __GNUC__

namespace kanexpr::detail {

template <int>
inline constexpr int address_probe = 0;

// The entities of a model are distinguished by their addresses.
inline constexpr bool addresses_are_distinct = __builtin_constant_p(&address_probe<0> == &address_probe<1>);
static_assert(addresses_are_distinct,
              "with -fsanitize=undefined, g++ also requires "
              "-fno-sanitize=null,nonnull-attribute,returns-nonnull-attribute after it "
              "to read a model; the target kanexpr::kanexpr passes this option");

template <bool goes_on, int count>
struct compilation {};
template <int count>
struct compilation<false, count> : compilation<false, count + 1> {};
template struct compilation<addresses_are_distinct, 0>;

} // namespace kanexpr::detail

#endif
