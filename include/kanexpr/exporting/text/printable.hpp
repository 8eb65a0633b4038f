#pragma once

#include <string>
#include <string_view>

namespace kanexpr::exporting {

/// Makes a text fit for comments and XML: valid UTF-8 without control characters. Each invalid byte becomes
/// an underscore.
inline std::string printable(std::string_view text) {
  std::string fit;
  while (!text.empty()) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
    bool is_fit = byte(0) < 0x80 ? byte(0) >= ' ' && byte(0) != 0x7f : byte(0) >= 0xc2 && byte(0) < 0xf5;
    is_fit = is_fit && length <= text.size();
    for (std::size_t i = 1; is_fit && i < length; ++i) is_fit = (byte(i) & 0xc0u) == 0x80;
    fit += is_fit ? text.substr(0, length) : "_";
    text.remove_prefix(is_fit ? length : 1);
  }
  return fit;
}

} // namespace kanexpr::exporting
