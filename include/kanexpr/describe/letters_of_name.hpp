#pragma once

#include <string_view>

namespace kanexpr::describe {

constexpr bool is_of_symbol_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Visits the letters of a name, with an underscore in place of each group of characters that are not allowed
/// in a symbol's name: `Link<3>` becomes Link_3. A sign becomes a word: `Link<-3>` is Link_minus3.
template <class Visit>
constexpr void each_letter_of_name(std::string_view name, Visit visit) {
  bool is_first = true, gap = false, negative = false;
  for (const char c : name) {
    if (!is_of_symbol_name(c)) {
      negative = c == '-' && (gap || is_first);
      gap = true;
      continue;
    }
    if (gap && !is_first) visit('_');
    if (negative)
      for (const char letter : std::string_view("minus")) visit(letter);
    is_first = gap = negative = false;
    visit(c);
  }
}

} // namespace kanexpr::describe
