#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>

#include <vector>

namespace kanexpr::figures {

/// The positions, orientations and loads of a model at a state, in inertial axes and in the order of the
/// model's lists.
struct geometry {
  std::vector<Eigen::Matrix3d> frames{}; ///< the basis vectors as columns
  std::vector<double> angles{};          ///< by which frames are rotated; 0 if a frame has no angle
  std::vector<Eigen::Vector3d> points{};
  std::vector<double> masses{};
  std::vector<Eigen::Matrix3d> inertias{}; ///< about the mass centers; zero for particles
  std::vector<Eigen::Vector3d> forces{}, torques{};
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  double size = 1; ///< the largest extent of the points along an axis, and at least that of a body

  kanexpr::status status{};
};

/// Evaluates the geometry of a model without a mistake. Loads that depend on inputs without a value or on
/// accelerations are zero.
KANEXPR_ENGINE geometry geometry_of(model& m, double t, const Eigen::VectorXd& x, const Eigen::VectorXd& p,
                                    const Eigen::VectorXd& r);

} // namespace kanexpr::figures

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/figures/geometry.ipp>
#endif
