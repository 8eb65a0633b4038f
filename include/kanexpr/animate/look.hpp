#pragma once

#include <kanexpr/animate/phrases.hpp>

#include <string_view>

namespace kanexpr {

namespace animate {

/// What a shape looks like and is called.
struct look {
  std::string_view colour{}; ///< "#rrggbb"; empty: the page chooses
  std::string_view name{};   ///< empty: what it is and where
  double opacity = 1;
};

template <class Option>
concept option_of_shape = requires(look& l) { Option::tell(l); };

template <class Option>
constexpr void tell(look& l) {
  if constexpr (option_of_shape<Option>) Option::tell(l);
}

template <class... Options>
constexpr look look_of() {
  look l;
  (tell<Options>(l), ...);
  return l;
}

template <class Option, std::size_t size>
constexpr void put_spin(phrases<size>& found, std::size_t& next) {
  if constexpr (requires { Option::spin; }) found[next++] = Option::spin;
}

/// The spin that is among the options.
template <class... Options>
constexpr auto spin_of() {
  phrases<(std::size_t{0} + ... + (requires { Options::spin; } ? 1 : 0))> found{};
  [[maybe_unused]] std::size_t next = 0;
  (put_spin<Options>(found, next), ...);
  return found;
}

} // namespace animate

/// `show<sphere<P, 0.1>, colour<"#c0392b">>`
template <text hexadecimal>
struct colour {
  static constexpr void tell(animate::look& l) { l.colour = hexadecimal.view(); }
};

/// From 0, which cannot be seen, to 1.
template <auto part>
struct opacity {
  static constexpr void tell(animate::look& l) { l.opacity = static_cast<double>(part); }
};

/// What the page calls a shape, in place of "sphere at P".
template <text words>
struct named {
  static constexpr void tell(animate::look& l) { l.name = words.view(); }
};

/// The shape turns about its axis beside its frame, with the rate `speed`, which is integrated along the
/// trajectory. For wheels whose angle matters to nothing, so that the model has no coordinate for it:
/// `show<wheel<R, C, R::y, r, 0.04>, spinning<u3>>`.
template <auto speed>
struct spinning {
  static constexpr describe::phrase spin = describe::phrase_of<speed>;
  static constexpr void tell(animate::look&) {}
};

} // namespace kanexpr
