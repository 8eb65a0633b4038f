#pragma once

#include <cstdint>
#include <string_view>

namespace kanexpr::ensembles {

/// Mixes bits so that each depends on all (Stafford's thirteenth variant of the finalizer of MurmurHash3, as
/// in Steele, Lea & Flood, OOPSLA 2014).
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

/// Random numbers that need no numbers before them: that of a place is the same on every machine, whoever
/// asks for it and when.
class random_stream {
public:
  /// What is drawn for one name from a seed does not depend on what is drawn for others.
  constexpr random_stream(std::uint64_t seed, std::string_view name) : key_(mixed(seed + step)) {
    for (char c : name) key_ = mixed((key_ + step) ^ static_cast<unsigned char>(c));
  }

  constexpr std::uint64_t bits(std::uint64_t place) const { return mixed(mixed(place * step + key_) ^ key_); }
  /// Between 0 and 1, and neither of them.
  constexpr double number(std::uint64_t place) const {
    return (static_cast<double>(bits(place) >> 12) + 0.5) * 0x1p-52;
  }

private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15;
  std::uint64_t key_;
};

} // namespace kanexpr::ensembles
