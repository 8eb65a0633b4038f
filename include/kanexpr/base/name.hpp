#pragma once

#include <cstddef>
#include <string_view>

namespace kanexpr::symbolic {

/// A short name that is a plain value, so that a graph of names can leave a constant evaluation. Of a longer
/// text, such as the name of a type, the middle is left out.
struct name {
  static constexpr int capacity = 63;
  char letters[capacity + 1]{};
  int length = 0;

  constexpr name() = default;
  constexpr name(std::string_view text) {
    constexpr std::size_t kept = capacity / 2 - 1;
    if (text.size() <= capacity)
      append(text);
    else
      append(text.substr(0, kept)), append("..."), append(text.substr(text.size() - kept));
  }
  constexpr name(const char* text) : name(std::string_view(text)) {}

  constexpr void append(std::string_view text) {
    for (char letter : text)
      if (length < capacity) letters[length++] = letter;
  }
  constexpr void append(int value) {
    if (value < 0) append("-"), value = -value;
    if (value >= 10) append(value / 10);
    const char digit = static_cast<char>('0' + value % 10);
    append(std::string_view(&digit, 1));
  }
  constexpr std::string_view view() const { return {letters, static_cast<std::size_t>(length)}; }
  constexpr bool operator==(const name& other) const {
    if (length != other.length) return false;
    for (int i = length - 1; i >= 0; --i) // names differ at their ends
      if (letters[i] != other.letters[i]) return false;
    return true;
  }
};

} // namespace kanexpr::symbolic
