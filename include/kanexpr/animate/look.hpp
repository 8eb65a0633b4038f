#pragma once

#include <kanexpr/animate/phrases.hpp>

#include <string_view>

namespace kanexpr {

namespace animate {

/// The appearance and the name of a shape.
struct look {
  std::string_view colour{}; ///< "#rrggbb"; empty: the page chooses
  std::string_view name{};   ///< empty: formed from its kind and place
  double opacity = 1;
};

template <class Option>
concept option_of_shape = requires(look& l) { Option::apply_to(l); };

template <class Option>
constexpr void apply_option(look& l) {
  if constexpr (option_of_shape<Option>) Option::apply_to(l);
}

template <class... Options>
constexpr look look_of() {
  look l;
  (apply_option<Options>(l), ...);
  return l;
}

template <class Option, std::size_t size>
constexpr void put_spin(phrases<size>& found, std::size_t& next) {
  if constexpr (requires { Option::spin; }) found[next++] = Option::spin;
}

/// Returns the `spinning` option, if there is one.
template <class... Options>
constexpr auto spin_of() {
  phrases<(std::size_t{0} + ... + (requires { Options::spin; } ? 1 : 0))> found{};
  [[maybe_unused]] std::size_t next = 0;
  (put_spin<Options>(found, next), ...);
  return found;
}

} // namespace animate

/// The color of a shape: `show<sphere<P, 0.1>, colour<"#c0392b">>`.
template <text hexadecimal>
struct colour {
  static constexpr void apply_to(animate::look& l) { l.colour = hexadecimal.view(); }
};

/// The opacity, from 0 (invisible) to 1.
template <auto part>
struct opacity {
  static constexpr void apply_to(animate::look& l) { l.opacity = static_cast<double>(part); }
};

/// The name of a shape on the page, in place of the default such as "sphere at P".
template <text words>
struct named {
  static constexpr void apply_to(animate::look& l) { l.name = words.view(); }
};

/// Makes the shape rotate about its axis relative to its frame, at the rate `speed`, which is integrated
/// along the trajectory. Intended for wheels whose angle does not affect the motion and is therefore not a
/// coordinate of the model: `show<wheel<R, C, R::y, r, 0.04>, spinning<u3>>`.
template <auto speed>
struct spinning {
  static constexpr describe::phrase spin = describe::phrase_of<speed>;
  static constexpr void apply_to(animate::look&) {}
};

} // namespace kanexpr
