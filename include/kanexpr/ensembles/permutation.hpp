#pragma once

#include <kanexpr/ensembles/random_stream.hpp>

#include <bit>
#include <cstdint>

namespace kanexpr::ensembles {

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
