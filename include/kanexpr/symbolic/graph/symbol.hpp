#pragma once

#include <kanexpr/base/name.hpp>

#include <string_view>

namespace kanexpr::symbolic {

/// The maximum length of a symbol name; the remaining characters are reserved for the primes of its
/// derivatives.
inline constexpr int max_name_length = base::name::capacity - 3;

constexpr bool is_name_start(char letter) { // beyond ASCII: part of a letter
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_' ||
         static_cast<unsigned char>(letter) >= 0x80;
}
/// Whether a character is neither a quote nor a control character.
constexpr bool is_printable(char letter) {
  return letter != '"' && static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f';
}

/// A name begins with a letter and has at most 60 characters, without primes, quotes or control characters;
/// primes denote rates.
constexpr bool is_name(std::string_view text) {
  if (text.empty() || text.size() > max_name_length || !is_name_start(text[0])) return false;
  for (char letter : text)
    if (!is_printable(letter) || letter == '\'') return false;
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
  auxiliary_speed, ///< always zero
  multiplier,      ///< Lagrange multiplier, the force of a constraint
  weight,          ///< weight of a state rate in a weighted sum of rates
  direction,       ///< perturbation of the state and the inputs
};

struct symbol {
  symbol_kind kind{};
  base::name called{};
  int position = 0; ///< index among symbols of its kind, in the order of the state, parameter or input vector

  constexpr bool operator==(const symbol& other) const {
    return kind == other.kind && called == other.called;
  }
};

} // namespace kanexpr::symbolic
