#pragma once

#include <kanexpr/figures/view.hpp>

namespace kanexpr::figures {

KANEXPR_ENGINE view view_of(const geometry& g, const Eigen::Vector3d& upward) {
  constexpr double nearly_one = 0.99;
  for (int axis : {2, 1, 0}) {
    const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
    if (std::abs(upward.normalized().dot(normal)) > nearly_one || !detail::is_planar(g, normal)) continue;
    view planar = detail::view_along(normal, upward);
    planar.is_planar = true;
    return planar;
  }
  constexpr double azimuth = 28 * std::numbers::pi / 180, elevation = 20 * std::numbers::pi / 180;
  const Eigen::Vector3d up = upward.normalized();
  int along = 0;
  up.cwiseAbs().maxCoeff(&along);
  const Eigen::Vector3d front =
      (Eigen::Vector3d::Unit((along + 1) % 3) - up * up((along + 1) % 3)).normalized();
  const Eigen::Vector3d side = up.cross(front);
  return detail::view_along((std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * side) +
                             std::sin(elevation) * up),
                            up);
}

KANEXPR_ENGINE view view_of(const geometry& g) {
  const auto nearest_axis = [](const Eigen::Vector3d& v) {
    int along = 0;
    v.cwiseAbs().maxCoeff(&along);
    return Eigen::Vector3d(Eigen::Vector3d::Unit(along));
  };
  if (!g.gravity.isZero()) {
    const Eigen::Vector3d up = -g.gravity.normalized();
    const bool is_across = detail::is_planar(g, nearest_axis(up)) && g.points.size() > 1;
    if (!is_across) return view_of(g, up);
  }
  const bool is_in_z = detail::is_planar(g, Eigen::Vector3d::UnitZ());
  return view_of(g, is_in_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ());
}

} // namespace kanexpr::figures
