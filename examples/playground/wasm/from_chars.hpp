#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

/// libc++ 19 lacks this overload of the standard library.
namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  char* end = nullptr;
  value = strtod(text.c_str(), &end);
  const auto read = end - text.c_str();
  return {first + read, read == 0 ? errc::invalid_argument : errc()};
}

} // namespace std
