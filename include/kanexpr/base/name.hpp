#pragma once

#include <cstddef>
#include <string_view>

namespace kanexpr::base {

/// A short name stored as a plain value, so that a graph that contains names can outlive constant evaluation.
/// Longer text, such as the name of a type, is shortened in the middle, so that names that differ near either
/// end stay different.
struct name {
  static constexpr int capacity = 63;
  char letters[capacity + 1]{};
  int length = 0;

  constexpr name() = default;
  constexpr name(std::string_view text) { append(text); }
  constexpr name(const char* text) : name(std::string_view(text)) {}

  constexpr void append(std::string_view text) {
    if (text.size() > static_cast<std::size_t>(capacity - length)) return append_to_full(text);
    for (char letter : text) letters[length++] = letter;
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
    for (int i = length - 1; i >= 0; --i) // names often differ only at the end
      if (letters[i] != other.letters[i]) return false;
    return true;
  }

private:
  constexpr void append_to_full(std::string_view text) {
    constexpr std::string_view left_out = "...";
    constexpr std::size_t kept = (capacity - left_out.size()) / 2;
    const name before = *this;
    const std::size_t own = before.view().size(), whole = own + text.size();
    const auto letter = [&](std::size_t i) { return i < own ? before.letters[i] : text[i - own]; };
    length = 0;
    for (std::size_t i = 0; i < kept; ++i) letters[length++] = letter(i);
    for (char dot : left_out) letters[length++] = dot;
    for (std::size_t i = whole - kept; i < whole; ++i) letters[length++] = letter(i);
  }
};

} // namespace kanexpr::base
