#pragma once

#include <string>

namespace kanexpr::simulated {

/// The name of the time column in a table: "t", or if the model uses that name, "time", then "time_" and so
/// on until the name is free.
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
