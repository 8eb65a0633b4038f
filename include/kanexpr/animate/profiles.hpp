#pragma once

#include <kanexpr/animate/attachment.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

/// The cross sections of swept shapes. Sizes are numbers or expressions that contain only parameters.
namespace kanexpr {

/// A circular profile.
template <auto radius>
struct circle {
  static constexpr std::string_view profile = "circle";
  static constexpr std::array<std::string_view, 1> size_names{"radius"};
  static constexpr auto sizes = animate::phrases_of<radius>;
};

/// A rectangular profile, centered at the station, with `width` along x and `height` along y.
template <auto width, auto height>
struct rectangle {
  static constexpr std::string_view profile = "rectangle";
  static constexpr std::array<std::string_view, 2> size_names{"width", "height"};
  static constexpr auto sizes = animate::phrases_of<width, height>;
};

/// The profile of an I beam, centered at the station, with flanges of `width` along x, `height` along y, and
/// `thickness` of the flanges and of the web.
template <auto width, auto height, auto thickness>
struct i_section {
  static constexpr std::string_view profile = "i_section";
  static constexpr std::array<std::string_view, 3> size_names{"width", "height", "thickness"};
  static constexpr auto sizes = animate::phrases_of<width, height, thickness>;
};

/// A symmetric airfoil of the NACA four-digit series with its chord along x; the station is at a quarter of
/// the chord, and the trailing edge in the direction of x. Source: Jacobs, Ward & Pinkerton (1933), NACA
/// Report 460.
template <auto chord, auto thickness>
struct airfoil {
  static constexpr std::string_view profile = "airfoil";
  static constexpr std::array<std::string_view, 2> size_names{"chord", "thickness"};
  static constexpr auto sizes = animate::phrases_of<chord, thickness>;
};

/// A profile whose sizes change linearly along the curve: `tapered<circle<0.1>, circle<0.03>>`.
template <class First, class Last>
struct tapered;

namespace animate {

template <class Profile>
concept profile_of_sweep = requires {
  Profile::profile;
  Profile::sizes;
};

template <class Type, std::size_t... sizes>
constexpr std::array<Type, (sizes + ... + 0)> joined(const std::array<Type, sizes>&... lists) {
  std::array<Type, (sizes + ... + 0)> all{};
  [[maybe_unused]] auto next = all.begin();
  ((next = std::copy(lists.begin(), lists.end(), next)), ...);
  return all;
}

} // namespace animate

template <animate::profile_of_sweep First, animate::profile_of_sweep Last>
struct tapered<First, Last> {
  static constexpr std::string_view profile = First::profile, last_profile = Last::profile;
  static constexpr auto size_names = animate::joined(First::size_names, Last::size_names);
  static constexpr auto sizes = animate::joined(First::sizes, Last::sizes);
};

} // namespace kanexpr
