#pragma once

#include <kanexpr/figures/canvas.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/view.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::figures {

/// A model and its geometry, seen in a view and drawn on a canvas.
struct drawing {
  const mechanics::multibody_system& system;
  const geometry& at;
  const view& seen;
  canvas on{};
  double scale = 1;                  ///< pixels per unit of length
  std::vector<int> place_of_frame{}; ///< the point at which the axes of each frame are drawn

  drawing(const mechanics::multibody_system& s, const geometry& g, const view& v);

  const mechanics::mechanism& mechanism() const { return system.mechanism; }
  Eigen::Vector2d picture(const Eigen::Vector3d& position) const { return scale * seen(position); }
  Eigen::Vector2d picture(int point) const { return picture(at.points[static_cast<std::size_t>(point)]); }
  const Eigen::Matrix3d& axes(int frame) const { return at.frames[static_cast<std::size_t>(frame)]; }
  /// The body with a frame; none if there is none.
  int body_of_frame(int frame) const;
  /// Whether a point is fixed in a frame at a distance from another one.
  bool has_links(int frame) const;
  /// The style of a body's color.
  std::string color_of_body(int body) const { return "b" + std::to_string(body % 6); }
  std::string name_of(const symbolic::expression& e) const;

  // in the order of their layers
  void draw_bodies();
  void draw_links(bool with_lengths);
  void draw_points(bool with_names);
  void draw_axes();
  void draw_angles();
  void draw_loads();
  void draw_gravity();
};

} // namespace kanexpr::figures
