#pragma once

/// What the library asks of a compiler and its options, beside C++20.

#if defined __GNUC__ && !defined __clang__ && __GNUC__ < 12
#error "kanexpr needs g++ 12 or later, or clang"
#elif defined __GNUC__

namespace kanexpr::describe {

template <int>
inline constexpr int one_of_many = 0;

// The entities of a model are told apart by their addresses.
static_assert(
    __builtin_constant_p(&one_of_many<0> == &one_of_many<1>),
    "with -fsanitize=undefined g++ needs -fno-sanitize=null,nonnull-attribute,returns-nonnull-attribute "
    "behind it to read a model; the target kanexpr::kanexpr passes it on");

} // namespace kanexpr::describe

#endif
