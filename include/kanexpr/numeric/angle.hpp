#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kanexpr::numeric {

/// Whether functions of a coordinate, `at(h)` beside where it stands, bend and are the same after whole
/// turns: then it is an angle, of size 1 in whatever units. What grows in proportion to it may be added to
/// them, as by springs. Turns of its multiples, and of halves to twelfths, are whole after twelve. Functions
/// that are zero but for rounding have no say: they bend differently a little farther on.
template <class Functions>
bool is_angle(const Functions& at) {
  const Eigen::VectorXd here = at(0.0);
  Eigen::VectorXd sizes = 2 * here.cwiseAbs();
  const auto bend = [&](double by) -> Eigen::VectorXd {
    const Eigen::VectorXd ahead = at(by), behind = at(-by);
    for (Eigen::Index i = 0; i < here.size(); ++i)
      sizes(i) = (std::max)(sizes(i), std::abs(ahead(i)) + std::abs(behind(i)));
    return (ahead - 2 * here + behind).cwiseAbs();
  };
  constexpr double little = 1e-8;
  const Eigen::VectorXd nearby = bend(1), further = bend(2.5),
                        rounding = (bend(1 + little) - nearby).cwiseAbs() +
                                   (bend(2.5 + little) - further).cwiseAbs(),
                        least = 1e-9 * sizes, turned = bend(24 * std::numbers::pi);
  int repeating = 0, others = 0;
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    const double bent = (std::max)(nearby(i), further(i));
    if (bent > least(i) && rounding(i) < 1e-4 * bent)
      ++(turned(i) <= 1e-6 * bent + least(i) ? repeating : others);
  }
  return repeating > others;
}

} // namespace kanexpr::numeric
