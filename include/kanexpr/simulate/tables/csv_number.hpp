#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace kanexpr::simulated {

/// Reads a number from its text. Returns the end of an error sentence; empty on success.
inline std::string_view read_number(std::string_view text, double& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range) return " is too large or too small for a double";
  if (error != std::errc() || end != text.data() + text.size()) return " is not a number";
  return {};
}

inline bool is_number(std::string_view text) {
  double number = 0;
  return read_number(text, number).empty();
}

} // namespace kanexpr::simulated
