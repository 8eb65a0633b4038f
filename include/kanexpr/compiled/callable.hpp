#pragma once

#include <kanexpr/compiled/fitting.hpp>

#include <type_traits>

namespace kanexpr::compiled {

/// Whether the first argument is omitted.
template <class First = not_given, class...>
inline constexpr bool lacks_first = std::is_same_v<First, not_given>;

/// The call operators that call `Function::called`; passing `{}` omits an argument.
template <class Function>
struct callable {
  template <class First>
  [[gnu::always_inline]] auto operator()(const First& first) const noexcept {
    return Function::called(first);
  }
  template <class First, class Second = not_given>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second) const noexcept {
    return Function::called(first, second);
  }
  template <class First, class Second = not_given, class Third = not_given>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second,
                                         const Third& third) const noexcept {
    return Function::called(first, second, third);
  }
  template <class First, class Second = not_given, class Third = not_given, class Fourth = not_given>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second, const Third& third,
                                         const Fourth& fourth) const noexcept {
    return Function::called(first, second, third, fourth);
  }
  template <class First, class Second = not_given, class Third = not_given, class Fourth = not_given,
            class... More>
  [[gnu::always_inline]] auto operator()(const First& first, const Second& second, const Third& third,
                                         const Fourth& fourth, const More&... more) const noexcept {
    return Function::called(first, second, third, fourth, more...);
  }
};

} // namespace kanexpr::compiled
