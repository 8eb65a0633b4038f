#pragma once

#include <kanexpr/figures/canvas.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/outlines.hpp>
#include <kanexpr/figures/view.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::figures {

namespace detail {

inline constexpr int no_axis = -1;

/// The nonzero component of a vector, if there is exactly one.
struct single_component {
  int frame = mechanics::none, axis = no_axis;
  symbolic::expression value{};
};

inline single_component single_component_of(const mechanics::vector& v) {
  single_component found;
  for (const mechanics::vector::part& part : v.parts)
    for (int axis = 0; axis < 3; ++axis) {
      if (part.value[axis].is_zero()) continue;
      if (found.axis != no_axis) return {};
      found = {part.frame, axis, part.value[axis]};
    }
  return found;
}

/// The frame of all nonzero components of a vector; none if there are several frames.
inline int frame_of(const mechanics::vector& v) {
  int frame = mechanics::none;
  for (const mechanics::vector::part& part : v.parts) {
    if (part.value.is_zero()) continue;
    if (frame != mechanics::none && frame != part.frame) return mechanics::none;
    frame = part.frame;
  }
  return frame;
}

} // namespace detail

/// A model and its geometry, seen in a view and drawn on a canvas.
struct drawing {
  const mechanics::multibody_system& system;
  const geometry& at;
  const view& seen;
  deflections bent_by;
  canvas on{};
  double scale;                      ///< pixels per unit of length
  std::vector<int> place_of_frame{}; ///< the point at which the axes of each frame are drawn

  drawing(const mechanics::multibody_system& s, const geometry& g, const view& v);

  const mechanics::mechanism& mechanism() const { return system.mechanism; }
  Eigen::Vector2d picture(const Eigen::Vector3d& position) const { return scale * seen(position); }
  Eigen::Vector2d picture(int point) const { return picture(at.points[static_cast<std::size_t>(point)]); }
  const Eigen::Matrix3d& axes(int frame) const { return at.frames[static_cast<std::size_t>(frame)]; }
  /// The body to which a frame belongs; none if there is no such body.
  int body_of_frame(int frame) const;
  /// Whether the offset between two points is fixed in a frame.
  bool has_links(int frame) const;
  /// Whether a frame is an intermediate rotation of a section.
  bool is_within_section(int frame) const;
  /// Whether the names of all axes and points would hide the rest.
  bool is_crowded() const { return mechanism().frames.size() > 9; }
  /// The style of a body's color.
  static std::string color_of_body(int body) { return "b" + std::to_string(body % 6); }
  bool has_symbol(std::string_view called) const;
  /// An expression without the sign of a negative product; the direction in which the quantity is drawn shows
  /// the sign.
  static std::string name_of_size(const symbolic::expression& e) {
    const std::string printed = symbolic::print_in_sentence(e);
    const bool is_sum = printed.find(" + ") != std::string::npos || printed.find(" - ") != std::string::npos;
    return printed.starts_with('-') && !is_sum ? printed.substr(1) : printed;
  }
};

inline drawing::drawing(const mechanics::multibody_system& s, const geometry& g, const view& v)
    : system(s), at(g), seen(v), bent_by(s.mechanism), scale(230 / g.size) {
  const mechanics::mechanism& m = s.mechanism;
  place_of_frame.assign(static_cast<std::size_t>(m.frames.size()), mechanics::none);
  const auto place = [&](int frame, int point) {
    if (frame == mechanics::none || point == mechanics::none) return;
    int& where = place_of_frame[static_cast<std::size_t>(frame)];
    if (where == mechanics::none) where = point;
  };
  for (int i = 0; i < m.points.size(); ++i)
    if (m.points[i].parent == mechanics::none) place(mechanics::mechanism::inertial, i);
  for (int f = 1; f < m.frames.size(); ++f) // the frame of a section has the name of its point
    for (int i = 0; i < m.points.size() && bent_by.turn(m.frames[f]); ++i)
      if (m.points[i].called == m.frames[f].called) place(f, i);
  for (const mechanics::point& p : m.points) place(detail::frame_of(p.offset), p.parent);
  for (const mechanics::body& b : m.bodies) place(b.frame, b.center);
  for (int f = m.frames.size() - 1; f > 0;
       --f) // an intermediate frame is drawn with the frames that follow it
    place(m.frames[f].parent, place_of_frame[static_cast<std::size_t>(f)]);
  for (int f = 1; f < m.frames.size(); ++f)
    place(f, place_of_frame[static_cast<std::size_t>(m.frames[f].parent)]);
}

inline int drawing::body_of_frame(int frame) const {
  const mechanics::mechanism& m = mechanism();
  for (int i = 0; i < m.bodies.size(); ++i)
    if (m.bodies[i].frame == frame) return i;
  return mechanics::none;
}

inline bool drawing::has_links(int frame) const {
  for (const mechanics::point& p : mechanism().points)
    if (p.parent != mechanics::none && detail::frame_of(p.offset) == frame) return true;
  return false;
}

inline bool drawing::is_within_section(int frame) const {
  if (!bent_by.turn(mechanism().frames[frame])) return false;
  for (const mechanics::frame& next : mechanism().frames)
    if (next.parent == frame && bent_by.turn(next)) return true;
  return false;
}

inline bool drawing::has_symbol(std::string_view called) const {
  const mechanics::mechanism& m = mechanism();
  for (const auto* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
    for (const symbolic::expression& e : *list)
      if (symbolic::print(e) == called) return true;
  return false;
}

} // namespace kanexpr::figures
