#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulate/event.hpp>
#include <kanexpr/simulate/trajectory.hpp>

#include <string>
#include <vector>

namespace kanexpr {

/// How a simulation went: the trajectory up to its end, and the reason if that is not the end of the span.
template <class System>
struct [[nodiscard]] simulation {
  kanexpr::trajectory<System> trajectory{};
  std::vector<occurrence> events{}; ///< in the order of time
  integration_statistics statistics{};
  double time = 0;                ///< where it ended
  kanexpr::state<System> state{}; ///< the state there
  bool stopped_by_event = false;  ///< as the handler of the last event asked
  std::string failure{};          ///< what went wrong, as a sentence; empty: nothing

  explicit operator bool() const { return failure.empty(); }
  std::string cause() const { return failure; }
};

} // namespace kanexpr
