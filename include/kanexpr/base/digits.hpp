#pragma once

#include <cstdio>
#include <string>

namespace kanexpr::base {

/// Formats a number for a message; a zero is written without a sign.
inline std::string digits(double number, int significant) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", significant, number + 0.0);
  return text;
}
inline std::string digits(double number) { return digits(number, 9); }

} // namespace kanexpr::base
