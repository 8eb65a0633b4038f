#pragma once

#include <cstdio>
#include <string>

namespace kanexpr::simulated {

/// A number in a sentence.
inline std::string digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

} // namespace kanexpr::simulated
