#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {

/// Why a text is no name, or nothing. `kinds` are what it would name one of, "parameters".
constexpr sentence check_name(std::string_view called, std::string_view kinds) {
  if (symbolic::is_name(called)) return {};
  if (called.empty()) return sentence({"one of the ", kinds, " has no name"});
  for (char letter : called)
    if (!symbolic::is_printed(letter))
      return sentence({"the name of one of the ", kinds, " holds a quote or a control character"});
  if (!symbolic::begins_name(called[0]))
    return sentence({"the name ", called, " does not begin with a letter"});
  for (char letter : called)
    if (letter == '\'') return sentence({"the name ", called, " holds a prime, which stands for a rate"});
  return sentence({"the name ", called, " is longer than a name can be, 60 letters"});
}

} // namespace kanexpr::mechanics
