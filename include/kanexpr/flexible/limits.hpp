#pragma once

#include <cstddef>

/// The largest bodies that are read, so that a small file cannot demand an unlimited amount of memory.
namespace kanexpr::flexible {

inline constexpr int most_amplitudes = 200;

/// The number of nodes whose positions, to the second order, contain at most ten million numbers.
constexpr std::size_t most_nodes(int amplitudes) {
  const auto n = static_cast<std::size_t>(amplitudes);
  return 10'000'000 / (3 * (1 + n + n * n));
}

} // namespace kanexpr::flexible
