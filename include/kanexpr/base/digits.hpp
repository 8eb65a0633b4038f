#pragma once

#include <cstdio>
#include <string>

namespace kanexpr::base {

/// Formats a number for a sentence; a zero is written without a sign.
inline std::string digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number + 0.0);
  return text;
}

} // namespace kanexpr::base
