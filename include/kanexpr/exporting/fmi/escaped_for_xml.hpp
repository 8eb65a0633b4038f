#pragma once

#include <kanexpr/exporting/text/printable.hpp>

#include <string>
#include <string_view>

namespace kanexpr::exporting {

/// Escapes text for use as an attribute value.
inline std::string escaped_for_xml(std::string_view text) {
  std::string escaped;
  for (const char c : printable(text)) switch (c) {
    case '&': escaped += "&amp;"; break;
    case '<': escaped += "&lt;"; break;
    case '>': escaped += "&gt;"; break;
    case '"': escaped += "&quot;"; break;
    default: escaped += c;
    }
  return escaped;
}

} // namespace kanexpr::exporting
