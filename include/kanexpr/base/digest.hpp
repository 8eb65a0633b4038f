#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace kanexpr::base {

/// An incremental 64-bit content hash.
class digest {
public:
  constexpr void take(std::uint64_t content) {
    value_ = (value_ ^ content) * 0x9fb21c651e98df25u;
    value_ ^= value_ >> 32; // otherwise differences in the highest bits would not spread
  }
  template <class Content>
    requires(std::signed_integral<Content> || std::is_enum_v<Content>)
  constexpr void take(Content content) {
    take(static_cast<std::uint64_t>(content));
  }
  constexpr void take(double content) { take(std::bit_cast<std::uint64_t>(content)); }
  constexpr void take(std::string_view content) {
    const std::uint64_t size = content.size();
    take(size);
    for (char letter : content) take(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  }

  constexpr std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

} // namespace kanexpr::base
