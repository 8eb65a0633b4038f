#pragma once

#include <string>

namespace kanexpr::simulated {

/// What the column of the time is called beside those of a model: "t", or if the model calls something that,
/// "time", and then "time_", as long as it takes.
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

} // namespace kanexpr::simulated
