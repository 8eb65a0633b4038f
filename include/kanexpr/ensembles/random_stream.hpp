#pragma once

#include <kanexpr/ensembles/content_hash.hpp>
#include <kanexpr/ensembles/philox.hpp>

#include <cstdint>
#include <string_view>

namespace kanexpr::ensembles {

/// The random numbers of one varied name. The seed is the key of the generator; the counter consists of the
/// number of the run and the hash of the name. So a draw depends neither on other draws nor on the order of
/// execution.
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

} // namespace kanexpr::ensembles
