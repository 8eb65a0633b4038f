#pragma once

/// What the library asks of a compiler and its options. Behind a sentence nothing else is said: an error
/// would not end the compilation, a file that is not there does, and so do classes that each need another
/// one.

#if __cplusplus < 202002L
#error "kanexpr needs C++20: compile with -std=c++20 or a later standard"
#include <nothing_without_c++20>
#define constexpr // clang++ reads on in silence, to a destructor at which it would crash
#elif defined __GNUC__ && !defined __clang__ && __GNUC__ < 12
#error "kanexpr needs g++ 12 or later, or clang"
#include <nothing_for_this_compiler>
#elif defined __GNUC__

namespace kanexpr::describe {

template <int>
inline constexpr int one_of_many = 0;

// The entities of a model are told apart by their addresses.
inline constexpr bool are_entities_apart = __builtin_constant_p(&one_of_many<0> == &one_of_many<1>);
static_assert(
    are_entities_apart,
    "with -fsanitize=undefined g++ needs -fno-sanitize=null,nonnull-attribute,returns-nonnull-attribute "
    "behind it to read a model; the target kanexpr::kanexpr passes it on");

template <bool goes_on, int count>
struct compilation {};
template <int count>
struct compilation<false, count> : compilation<false, count + 1> {};
template struct compilation<are_entities_apart, 0>;

} // namespace kanexpr::describe

#endif
