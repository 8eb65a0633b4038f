#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The points at which a program is called, the same on the board and on the host.
namespace embedded {

inline constexpr std::size_t point_count = 8;

/// `Program::given`, then the same with the first `Program::varied` entries moved by up to `Program::spread`:
/// the numbers are from a random generator (Park & Miller 1988).
template <class Program, class T>
constexpr auto points() {
  constexpr std::size_t size = Program::given.size();
  std::array<std::array<T, size>, point_count> all{};
  std::int64_t seed = 1;
  for (std::size_t k = 0; k < point_count; ++k)
    for (std::size_t i = 0; i < size; ++i) {
      seed = seed * 48271 % 2147483647;
      const double off = 2 * static_cast<double>(seed) / 2147483647 - 1;
      const bool moves = k > 0 && i < Program::varied;
      all[k][i] = static_cast<T>(Program::given[i] + (moves ? Program::spread * off : 0));
    }
  return all;
}

} // namespace embedded
