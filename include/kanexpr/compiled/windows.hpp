#pragma once

#include <cstddef>

namespace kanexpr::compiled {

/// Where windows of `width` neighbouring entries begin that together contain some entries of an array. All
/// but the last begin at multiples of their width, so that they do not cross lines of a cache.
template <int size, int width>
struct windows {
  int first[static_cast<std::size_t>(size / width + 1)]{};
  int count = 0;

  /// `contains(i)` returns whether entry i must be in a window.
  template <class Contains>
  constexpr explicit windows(const Contains& contains) {
    static_assert(size >= width);
    for (int begin = 0; begin < size; begin += width) {
      bool is_needed = false;
      for (int i = begin; i < begin + width && i < size; ++i) is_needed = is_needed || contains(i);
      if (is_needed) first[count++] = begin + width <= size ? begin : size - width;
    }
  }
};

} // namespace kanexpr::compiled
