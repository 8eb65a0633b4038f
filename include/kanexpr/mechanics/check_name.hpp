#pragma once

#include <kanexpr/mechanics/problem.hpp>
#include <kanexpr/symbolic/symbol.hpp>

namespace kanexpr::mechanics {

/// How long the name of a symbol may be: the primes of its derivatives come behind it.
inline constexpr int longest_name = symbolic::name::capacity - 3;

/// A name begins with a letter and has at most 60, none of which is a prime, a quote or a control character:
/// primes stand for rates. `kinds` are what it names one of, "parameters".
constexpr problem check_name(std::string_view called, std::string_view kinds) {
  if (called.empty()) return sentence({"one of the ", kinds, " has no name; a name is a text between quotes"});
  for (char letter : called)
    if (letter == '"' || static_cast<unsigned char>(letter) < ' ' || letter == '\x7f')
      return sentence({"the name of one of the ", kinds, " holds a quote or a control character"});
  const char first = called[0];
  if (!(first >= 'a' && first <= 'z') && !(first >= 'A' && first <= 'Z') && first != '_' &&
      static_cast<unsigned char>(first) < 0x80) // beyond ASCII it is a part of a letter
    return sentence({"the name ", called, " does not begin with a letter"});
  for (char letter : called)
    if (letter == '\'') return sentence({"the name ", called, " holds a prime, which stands for a rate"});
  if (called.size() > static_cast<std::size_t>(longest_name))
    return sentence({"the name ", called, " is longer than a name can be, 60 letters"});
  return {};
}

} // namespace kanexpr::mechanics
