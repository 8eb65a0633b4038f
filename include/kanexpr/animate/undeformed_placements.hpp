#pragma once

#include <kanexpr/animate/animation.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kanexpr::animate {

/// Returns the placements of a shape while no flexible body is deformed; empty if they do not differ. Traces
/// keep the true path.
inline std::vector<placement> undeformed_placements(const animation::shape& s,
                                                    const std::vector<placement>& straight) {
  if (s.kind == "trace" || straight.size() != s.placements.size()) return {};
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const placement &here = s.placements[i], &there = straight[i];
    largest = (std::max)(largest, here.position.lpNorm<Eigen::Infinity>());
    difference = (std::max)({difference, (here.position - there.position).lpNorm<Eigen::Infinity>(),
                             s.kind == "arrow" ? 0 : (here.end - there.end).lpNorm<Eigen::Infinity>(),
                             (here.orientation - there.orientation).lpNorm<Eigen::Infinity>()});
  }
  return difference > 1e-7 * (1 + largest) ? straight : std::vector<placement>();
}

} // namespace kanexpr::animate
