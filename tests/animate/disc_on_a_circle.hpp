#pragma once

#include "animate/samples.hpp"

#include <models/rolling_disc.hpp>

#include <Eigen/Geometry>

namespace tests {

/// A disc that leans by a constant angle and rolls in a circle, in closed form. It rolls without
/// slipping but does not satisfy the equations of motion.
struct disc_on_a_circle {
  double radius = 0.3, lean = 0.35, turning = 0.8, spin = 4.1; ///< rates of q1 and q3

  kanexpr::state<rolling_disc::System> operator()(double t) const {
    using namespace rolling_disc;
    kanexpr::state<System> x;
    x[q1] = turning * t;
    x[q2] = lean;
    x[q3] = spin * t;
    x[u1] = 0;
    x[u2] = spin + turning * std::sin(lean);
    x[u3] = turning * std::cos(lean);
    return x;
  }

  /// The mass center moves with ω × r = radius u2 along the heading, which turns.
  Eigen::Vector3d centre(double t) const {
    const double speed = radius * (spin + turning * std::sin(lean)), yaw = turning * t;
    return Eigen::Vector3d(0, -radius * std::sin(lean), radius * std::cos(lean)) +
           speed / turning * Eigen::Vector3d(std::sin(yaw), 1 - std::cos(yaw), 0);
  }
  Eigen::Vector3d contact(double t) const {
    return centre(t) -
           axes(t) * Eigen::AngleAxisd(-spin * t, Eigen::Vector3d::UnitY()) * Eigen::Vector3d(0, 0, radius);
  }
  /// The columns are the disc's axes.
  Eigen::Matrix3d axes(double t) const {
    using Eigen::AngleAxisd, Eigen::Vector3d;
    return (AngleAxisd(turning * t, Vector3d::UnitZ()) * AngleAxisd(lean, Vector3d::UnitX()) *
            AngleAxisd(spin * t, Vector3d::UnitY()))
        .matrix();
  }
  /// The axes of a shape about the y axis of the disc: x as in the disc, z along the axis.
  Eigen::Matrix3d about_spin(double t) const {
    Eigen::Matrix3d turned;
    turned << axes(t).col(0), -axes(t).col(2), axes(t).col(1);
    return turned;
  }

  kanexpr::parameter_values<rolling_disc::System> parameters() const {
    using namespace rolling_disc;
    kanexpr::parameter_values<System> p;
    p[r] = radius;
    p[m] = 2;
    p[g] = 9.81;
    return p;
  }
};

} // namespace tests
