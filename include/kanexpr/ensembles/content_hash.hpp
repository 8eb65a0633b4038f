#pragma once

#include <cstdint>
#include <string_view>

namespace kanexpr::ensembles {

/// 64-bit content hash: FNV-1a (Fowler, Noll & Vo).
constexpr std::uint64_t content_hash(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char each : content) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3;
  return hash;
}

} // namespace kanexpr::ensembles
