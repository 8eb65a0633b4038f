#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kanexpr::numeric {

/// Whether functions of a coordinate are nonlinear and repeat after full turns; `at(h)` returns their values
/// at the offset h from the current coordinate. If they do, the coordinate is an angle, and its typical size
/// is 1 in any units. The functions may also contain terms linear in the coordinate, such as those of
/// springs. Functions of multiples of the angle, and of its halves, thirds, quarters, sixths and twelfths,
/// all repeat after twelve turns. Functions that vanish up to rounding are ignored: their curvature changes
/// at a slightly different offset.
template <class Functions>
bool is_angle(const Functions& at) {
  const Eigen::VectorXd here = at(0.0);
  Eigen::VectorXd sizes = here;
  for (double& size : sizes) size = 2 * std::abs(size);
  const auto bend = [&](double by) {
    Eigen::VectorXd bent = at(by);
    const Eigen::VectorXd backward = at(-by);
    for (Eigen::Index i = 0; i < here.size(); ++i) {
      sizes(i) = (std::max)(sizes(i), std::abs(bent(i)) + std::abs(backward(i)));
      bent(i) = std::abs(bent(i) - 2 * here(i) + backward(i));
    }
    return bent;
  };
  constexpr double little = 1e-8;
  const Eigen::VectorXd nearby = bend(1), further = bend(2.5), nearby_shifted = bend(1 + little),
                        further_shifted = bend(2.5 + little);
  const Eigen::VectorXd measured = sizes, turned = bend(24 * std::numbers::pi);
  int repeating = 0, others = 0;
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    const double bent = (std::max)(nearby(i), further(i)), least = 1e-9 * measured(i);
    const double rounding =
        std::abs(nearby_shifted(i) - nearby(i)) + std::abs(further_shifted(i) - further(i));
    if (bent > least && rounding < 1e-4 * bent) ++(turned(i) <= 1e-6 * bent + least ? repeating : others);
  }
  return repeating > others;
}

} // namespace kanexpr::numeric
