#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace kanexpr::animate {

/// A homogeneous solid that has the mass and the inertia of a body: a sphere, a cylinder or a box.
struct homogeneous_solid {
  std::string kind{};                                 ///< a kind of shape; empty if the body has no extent
  std::vector<double> sizes{};                        ///< those of the shape
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< its axes, in those of the inertia

  bool exists() const { return !kind.empty(); }
  /// The largest dimension.
  double extent() const {
    if (!exists()) return 0;
    const double radius_or_edge = kind == "box" ? sizes[0] : 2 * sizes[0];
    return (std::max)(radius_or_edge, *std::ranges::max_element(sizes));
  }
};

/// The radius of a sphere is √(5 s), that of a cylinder 2 √s, and lengths are √(12 s), where s is the mean
/// square of a coordinate over the mass. Dimensions below 3 % of the largest are raised to it, so that discs
/// and rods remain visible.
inline homogeneous_solid solid_of(double mass, const Eigen::Matrix3d& inertia) {
  constexpr double equal_within = 0.02, thinnest = 0.03;
  if (!(mass > 0) || !inertia.allFinite() || inertia.isZero()) return {};
  const Eigen::Matrix3d squares = (0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia) / mass;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(squares);
  const Eigen::Vector3d s = principal.eigenvalues().cwiseMax(0.0); // in increasing order
  if (!(s(2) > 0)) return {};
  homogeneous_solid solid;
  solid.axes = principal.eigenvectors();
  if (solid.axes.determinant() < 0) solid.axes.col(1) *= -1;
  const auto are_equal = [&](int i, int j) { return s(j) - s(i) <= equal_within * s(j); };
  const auto length = [](double square) { return std::sqrt(12 * square); };
  const auto cylinder = [&](int along, int across) {
    const double radius = 2 * std::sqrt(s(across)), height = length(s(along));
    const double least = thinnest * (std::max)(radius, height);
    solid.kind = "cylinder", solid.sizes = {(std::max)(radius, least), (std::max)(height, least)};
    if (along == 0)
      solid.axes = (Eigen::Matrix3d() << solid.axes.rightCols<2>(), solid.axes.col(0)).finished();
  };
  if (are_equal(0, 2))
    solid.kind = "sphere", solid.sizes = {std::sqrt(5 * s(2))};
  else if (are_equal(0, 1) || s(1) < equal_within * equal_within * s(2))
    cylinder(2, 1);
  else if (are_equal(1, 2))
    cylinder(0, 2);
  else
    solid.kind = "box", solid.sizes = {length(s(0)), length(s(1)), length(s(2))};
  for (double& size : solid.sizes) size = (std::max)(size, thinnest * length(s(2)));
  return solid;
}

} // namespace kanexpr::animate
