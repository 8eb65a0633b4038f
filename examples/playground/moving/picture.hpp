#pragma once

#include <kanexpr/figures/draw_axes.hpp>
#include <kanexpr/figures/draw_bodies.hpp>
#include <kanexpr/figures/draw_loads.hpp>
#include <kanexpr/figures/drawing.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/view.hpp>
#include <kanexpr/runtime/model.hpp>

#include "playground/moving/moving_model.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>

namespace playground {

/// The figure of a moving model, in a view and at a scale that do not change with the motion.
class picture {
public:
  picture(kanexpr::model& m, moving_model& moving) : model_(m), moving_(moving) {
    size_ = geometry().size;
    home_ = seen_ = kanexpr::figures::view_of(generic_geometry());
  }

  bool is_planar() const { return home_.is_planar; }

  /// Turns the view of a spatial model, in radians from its first position.
  void turn(double azimuth, double elevation) {
    if (is_planar()) return;
    using Eigen::AngleAxisd;
    const Eigen::Vector3d raised = AngleAxisd(-elevation, home_.right) * home_.eye;
    const Eigen::Vector3d up = upward();
    seen_ = kanexpr::figures::detail::view_along((AngleAxisd(azimuth, up) * raised).normalized(), up);
  }

  /// The figure as SVG; empty if a point is not at a finite place near enough to be drawn. Without labels it
  /// contains what moves, without names, lengths and angles.
  std::string svg(bool has_labels) {
    if (!is_within_reach()) return "";
    kanexpr::figures::geometry at = geometry();
    if (!at.cause.empty()) return "";
    at.size = size_;
    kanexpr::figures::drawing shown(model_.system(), at, seen_);
    kanexpr::figures::draw_bodies(shown);
    kanexpr::figures::draw_links(shown, has_labels);
    kanexpr::figures::draw_points(shown, has_labels);
    if (has_labels) {
      kanexpr::figures::draw_axes(shown);
      kanexpr::figures::draw_angles(shown);
      kanexpr::figures::draw_loads(shown), kanexpr::figures::draw_gravity(shown);
    }
    return shown.on.svg("The model at t = " + std::to_string(moving_.t) + " s");
  }

  /// The points in the coordinates of the SVG.
  Eigen::Matrix2Xd points() {
    Eigen::Matrix2Xd all = pixels_per_meter() * (plane() * moving_.points());
    all.row(1) *= -1;
    return all;
  }
  /// Moves a point toward a place in the coordinates of the SVG.
  void drag(int point, double across, double down) {
    moving_.drag(point, plane(), Eigen::Vector2d(across, -down) / pixels_per_meter());
  }

private:
  bool is_within_reach() {
    constexpr double farthest = 1e7; // pixels
    const Eigen::Matrix3Xd at = moving_.points();
    return moving_.x.allFinite() && (pixels_per_meter() * at.array().abs() < farthest).all();
  }
  double pixels_per_meter() const { return 230 / size_; } // as in a drawing
  Eigen::Vector3d upward() const { return nearest_axis(home_.up); }
  static Eigen::Vector3d nearest_axis(const Eigen::Vector3d& v) {
    int axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    return Eigen::Vector3d::Unit(axis) * (v(axis) < 0 ? -1 : 1);
  }
  Eigen::Matrix<double, 2, 3> plane() const {
    Eigen::Matrix<double, 2, 3> rows;
    rows << seen_.right.transpose(), seen_.up.transpose();
    return rows;
  }
  /// The geometry at a state without symmetries, at which a spatial model does not happen to lie in a plane.
  kanexpr::figures::geometry generic_geometry() {
    const Eigen::VectorXd x = moving_.x;
    for (int i = 0; i < moving_.coordinates(); ++i) moving_.x(i) += 0.1 + 0.07 * i;
    kanexpr::figures::geometry found = geometry();
    moving_.x = x;
    return found.cause.empty() ? found : geometry();
  }
  kanexpr::figures::geometry geometry() {
    return kanexpr::figures::geometry_of(model_, moving_.t, moving_.x, moving_.p, moving_.r);
  }

  kanexpr::model& model_;
  moving_model& moving_;
  double size_ = 1;
  kanexpr::figures::view home_{}, seen_{};
};

} // namespace playground
