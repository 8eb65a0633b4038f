#pragma once

#include <string>
#include <string_view>

namespace kanexpr::robots {

/// Returns text from a file for use in a sentence: truncated and without control characters.
inline std::string shown(std::string_view text, std::size_t most = 60) {
  std::string plain;
  for (char c : text.substr(0, most)) plain += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return text.size() > most ? plain + "..." : plain;
}

} // namespace kanexpr::robots
