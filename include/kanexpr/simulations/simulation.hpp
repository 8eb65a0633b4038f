#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulations/events/event.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>

#include <string>
#include <vector>

namespace kanexpr {

/// The result of a simulation: the trajectory up to its end, and the cause if it ended before the end of the
/// span.
template <class System>
struct [[nodiscard]] simulation {
  kanexpr::trajectory<System> trajectory{};
  std::vector<occurrence> events{}; ///< in chronological order
  integration_statistics statistics{};
  double time = 0;                ///< the time at which it ended
  kanexpr::state<System> state{}; ///< the state at that time
  bool stopped_by_event = false;  ///< as the handler of the last event requested
  std::string failure{};          ///< the cause of a failure, as a sentence; empty on success

  explicit operator bool() const { return failure.empty(); }
  std::string cause() const { return failure; }
};

} // namespace kanexpr
