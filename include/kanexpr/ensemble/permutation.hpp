#pragma once

#include <kanexpr/ensemble/random_number.hpp>

#include <bit>

namespace kanexpr::ensembles {

/// A random order of the numbers below `size` that is not stored: a cipher of that many values, by a Feistel
/// network on the next power of four, walked until it is below the size (Black & Rogaway, CT-RSA 2002).
class permutation {
public:
  constexpr permutation(const random_stream& from, std::uint64_t size)
      : from_(from), size_(size),
        half_((static_cast<unsigned>(std::bit_width(size > 1 ? size - 1 : 1)) + 1) / 2) {}

  constexpr std::uint64_t operator()(std::uint64_t place) const {
    do place = enciphered(place);
    while (place >= size_);
    return place;
  }

private:
  constexpr std::uint64_t enciphered(std::uint64_t place) const {
    const std::uint64_t low = (std::uint64_t{1} << half_) - 1;
    std::uint64_t left = place >> half_, right = place & low;
    for (std::uint64_t round = 0; round < 6; ++round) {
      const std::uint64_t next = left ^ (from_.bits((round << 32) + right) & low);
      left = right, right = next;
    }
    return left << half_ | right;
  }

  random_stream from_;
  std::uint64_t size_;
  unsigned half_; ///< the bits of a half
};

} // namespace kanexpr::ensembles
