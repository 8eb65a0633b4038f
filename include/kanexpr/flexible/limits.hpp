#pragma once

#include <cstddef>

/// The largest bodies that are read, so that a small file cannot demand an unlimited amount of memory.
namespace kanexpr::flexible {

inline constexpr int most_amplitudes = 200;

/// The largest number of coefficients of one matrix or list.
inline constexpr std::size_t most_series_entries = 10'000'000;

/// The number of nodes whose positions, to the second order, contain at most ten million numbers.
constexpr std::size_t most_nodes(int amplitudes) {
  const auto n = static_cast<std::size_t>(amplitudes);
  return most_series_entries / (3 * (1 + n + n * n));
}

/// Whether the terms of second order of a matrix with the given number of entries are within the limit.
constexpr bool fits_second_order(int entries, int amplitudes) {
  const auto n = static_cast<std::size_t>(amplitudes);
  return static_cast<std::size_t>(entries) * n * n <= most_series_entries;
}

} // namespace kanexpr::flexible
