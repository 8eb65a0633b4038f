#pragma once

#include <kanexpr/kanexpr.hpp>

#include <utility>
#include <vector>

/// Results of systems that the compiler derived. Each comes from a separate file, so that the build can
/// measure the time that the compiler needs for it.
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

} // namespace demo
