#pragma once

#include <kanexpr/kanexpr.hpp>

#include <string>
#include <utility>
#include <vector>

/// What the demo shows, from a file of its own for each system, so that the build can tell what the compiler
/// needed to derive it.
namespace demo {

struct compiled {
  Eigen::VectorXd udot;
  Eigen::VectorXd reference;
  std::vector<std::pair<const char*, kanexpr::symbolic::cost>> costs;
  double nanoseconds; ///< of one evaluation of the last of them
};

compiled compiled_rolling_disc();
compiled compiled_iiwa();
compiled compiled_bicycle();

// Each prints its part, and says whether it is as it should be.
bool show_rolling_disc();
bool show_iiwa();
bool show_bicycle();
/// Leaves the motions of the bicycle in a folder.
bool show_rides(const std::string& folder);

} // namespace demo
