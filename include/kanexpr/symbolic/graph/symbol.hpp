#pragma once

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

/// How long the name of a symbol may be: the primes of its derivatives come behind it.
inline constexpr int longest_name = name::capacity - 3;

constexpr bool begins_name(char letter) { // beyond ASCII it is a part of a letter
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_' ||
         static_cast<unsigned char>(letter) >= 0x80;
}
/// Neither a quote nor a control character.
constexpr bool is_printed(char letter) {
  return letter != '"' && static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f';
}

/// A name begins with a letter and has at most 60, none of which is a prime, a quote or a control character:
/// primes stand for rates.
constexpr bool is_name(std::string_view text) {
  if (text.empty() || text.size() > longest_name || !begins_name(text[0])) return false;
  for (char letter : text)
    if (!is_printed(letter) || letter == '\'') return false;
  return true;
}

enum class symbol_kind : unsigned char {
  time,
  coordinate, ///< generalized coordinate q
  speed,      ///< generalized speed u
  parameter,
  input,
  coordinate_rate, ///< dq/dt
  speed_rate,      ///< du/dt
  auxiliary_speed, ///< zero at all times
  multiplier,      ///< Lagrange's, the force of a constraint
};

struct symbol {
  symbol_kind kind{};
  name called{};
  int position = 0; ///< among the symbols of its kind, in the order of the state, parameter or input vector

  constexpr bool operator==(const symbol& other) const {
    return kind == other.kind && called == other.called;
  }
};

} // namespace kanexpr::symbolic
