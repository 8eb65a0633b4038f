#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// Returns a message that explains why a text is not a valid name; empty if it is valid. `kinds` denotes the
/// named entities, such as "parameters".
constexpr base::sentence check_name(std::string_view called, std::string_view kinds) {
  if (symbolic::is_name(called)) return {};
  if (called.empty()) return base::sentence({"one of the ", kinds, " has no name"});
  for (char letter : called)
    if (!symbolic::is_printable(letter))
      return base::sentence({"the name of one of the ", kinds, " contains a quote or a control character"});
  if (!symbolic::is_name_start(called[0]))
    return base::sentence({"the name ", called, " does not begin with a letter"});
  for (char letter : called)
    if (letter == '\'')
      return base::sentence({"the name ", called, " contains a prime, which denotes a rate"});
  return base::sentence({"the name ", called, " is longer than 60 characters"});
}

} // namespace kanexpr::mechanics
