#pragma once

#include <string>

namespace kanexpr::base {

/// Returns the name of the time column in a table: "t", or, if the model uses that name, the first unused
/// name of "time", "time_" and so on.
template <class IsTaken>
std::string name_of_time(const IsTaken& is_taken) {
  std::string name = "t";
  while (is_taken(name))
    if (name == "t")
      name = "time";
    else
      name += '_';
  return name;
}

} // namespace kanexpr::base
