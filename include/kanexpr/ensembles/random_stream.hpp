#pragma once

#include <kanexpr/base/bytes.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace kanexpr::ensembles {

/// Philox4x32-10, a counter-based random number generator (Salmon, Moraes, Dror & Shaw, SC11, 2011): 128
/// random bits for each pair of a counter and a key.
constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                              std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {
        static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
        static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9, key[1] += 0xBB67AE85;
  }
  return counter;
}

/// The random numbers of one varied name. The seed is the key of the generator; the counter consists of the
/// number of the run and the hash of the name. Therefore, a draw depends neither on other draws nor on the
/// order of execution.
class random_stream {
public:
  constexpr random_stream(std::uint64_t seed, std::string_view name)
      : seed_(seed), name_(content_hash(name)) {}

  constexpr std::uint64_t bits(std::uint64_t run) const {
    const auto random = philox({low(run), high(run), low(name_), high(name_)}, {low(seed_), high(seed_)});
    return std::uint64_t{random[1]} << 32 | random[0];
  }
  /// Uniform in the open interval (0, 1).
  constexpr double number(std::uint64_t run) const {
    return (static_cast<double>(bits(run) >> 12) + 0.5) * 0x1p-52;
  }

private:
  static constexpr std::uint32_t low(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
  static constexpr std::uint32_t high(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

  std::uint64_t seed_, name_;
};

/// A random permutation of the integers below `size`, computed instead of stored: a Feistel cipher on the
/// next power of four, repeated until the result is below the size (Black & Rogaway, CT-RSA 2002).
class permutation {
public:
  constexpr permutation(const random_stream& from, std::uint64_t size)
      : from_(from), size_(size),
        half_bits_((static_cast<unsigned>(std::bit_width(size > 1 ? size - 1 : 1)) + 1) / 2) {}

  constexpr std::uint64_t operator()(std::uint64_t place) const {
    do place = enciphered(place);
    while (place >= size_);
    return place;
  }

private:
  constexpr std::uint64_t enciphered(std::uint64_t place) const {
    const std::uint64_t low = (std::uint64_t{1} << half_bits_) - 1;
    std::uint64_t left = place >> half_bits_, right = place & low;
    for (std::uint64_t round = 0; round < 6; ++round) {
      const std::uint64_t next = left ^ (from_.bits((round << 32) + right) & low);
      left = right, right = next;
    }
    return left << half_bits_ | right;
  }

  random_stream from_;
  std::uint64_t size_;
  unsigned half_bits_;
};

} // namespace kanexpr::ensembles
