#pragma once

#include <kanexpr/compiled/vector_checks.hpp>

#include <type_traits>

namespace kanexpr::compiled {

/// Whether the first argument is omitted.
template <class First = omitted, class...>
inline constexpr bool first_is_omitted = std::is_same_v<First, omitted>;

/// Call operators that forward to `Function::called`; passing `{}` omits an argument.
template <class Function>
struct callable {
  template <class First>
  [[gnu::always_inline]] auto operator()(const First& first) const noexcept {
    return Function::called(first);
  }
  template <class First, class Second = omitted>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second) const noexcept {
    return Function::called(first, second);
  }
  template <class First, class Second = omitted, class Third = omitted>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second,
                                         const Third& third) const noexcept {
    return Function::called(first, second, third);
  }
  template <class First, class Second = omitted, class Third = omitted, class Fourth = omitted>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second, const Third& third,
                                         const Fourth& fourth) const noexcept {
    return Function::called(first, second, third, fourth);
  }
  template <class First, class Second = omitted, class Third = omitted, class Fourth = omitted, class... More>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second, const Third& third,
                                         const Fourth& fourth, const More&... more) const noexcept {
    return Function::called(first, second, third, fourth, more...);
  }
};

} // namespace kanexpr::compiled
