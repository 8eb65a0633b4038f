#pragma once

#include <kanexpr/figures/drawing.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace kanexpr::figures {

namespace detail {

inline constexpr double axis_length = 46; ///< in pixels

} // namespace detail

/// An axis that points toward the eye or away from it, as a circle with a dot or a cross.
inline void draw_axis_along_sight(drawing& d, const Eigen::Vector2d& at, bool is_toward_eye) {
  d.on.circle(layer::axes, at, 5, "hollow");
  if (is_toward_eye) return d.on.circle(layer::axes, at, 1.2, "filled");
  for (const double side : {1.0, -1.0})
    d.on.line(layer::axes, at + Eigen::Vector2d(-3.5, -3.5 * side), at + Eigen::Vector2d(3.5, 3.5 * side),
              "axis");
}

inline void draw_axis(drawing& d, int frame, int axis, const Eigen::Vector2d& origin, bool with_name) {
  const Eigen::Vector3d direction = d.axes(frame).col(axis);
  const Eigen::Vector2d along = d.seen(direction);
  Eigen::Vector2d tip = origin + (frame == 0 ? 1.2 : 1.0) * detail::axis_length * along, away = along;
  if (along.norm() < 0.05) {
    if (frame != mechanics::mechanism::inertial) return;
    tip = origin + Eigen::Vector2d(-18, 12), away = {-1, 0.3};
    draw_axis_along_sight(d, tip, d.seen.toward_eye(direction) > 0);
  } else {
    const int body = d.body_of_frame(frame);
    const std::string color = frame == 0                ? ""
                              : body == mechanics::none ? " pale"
                                                        : " " + d.color_of_body(body);
    d.on.arrow(layer::axes, origin, tip, "axis" + color);
  }
  const std::string name = std::string(d.mechanism().frames[frame].called.view()) + '.' + "xyz"[axis];
  if (with_name) d.on.label(tip, away, typeset(name), "name");
}

/// Draws the axes of all frames; in a crowded figure, names only those of the inertial frame.
inline void draw_axes(drawing& d) {
  for (int f = 0; f < d.mechanism().frames.size(); ++f) {
    const int place = d.place_of_frame[static_cast<std::size_t>(f)];
    if (place == mechanics::none || d.is_within_section(f)) continue;
    for (int axis = 0; axis < 3; ++axis) draw_axis(d, f, axis, d.picture(place), f == 0 || !d.is_crowded());
  }
}

inline int first_axis_used(const drawing& d, int frame) {
  for (const mechanics::point& p : d.mechanism().points) {
    const detail::single_component along = detail::single_component_of(p.offset);
    if (along.frame == frame) return along.axis;
  }
  return detail::no_axis;
}

/// An arc from the direction that an axis of the frame would have without the rotation to its actual
/// direction. If the rotation moves the axis of the first offset in the frame, the arc uses that axis.
inline void draw_angle(drawing& d, int f, int place, double radius) {
  const auto which = static_cast<std::size_t>(f);
  const Eigen::Vector3d about = d.at.rotation_axes[which];
  const auto across = [&](int axis) -> Eigen::Vector3d {
    const Eigen::Vector3d v = d.axes(f).col(axis);
    return v - about * about.dot(v);
  };
  int axis = first_axis_used(d, f);
  if (axis == detail::no_axis || across(axis).norm() < 0.5) {
    axis = 0;
    for (int other : {1, 2})
      if (across(other).norm() > across(axis).norm() + 1e-9) axis = other;
  }
  const double angle = std::remainder(d.at.angles[which], 2 * std::numbers::pi);
  const Eigen::Vector3d end = across(axis).normalized();
  const Eigen::Vector2d here = d.picture(place);
  const auto on_arc = [&](double from_end) -> Eigen::Vector2d {
    return radius * d.seen(Eigen::AngleAxisd(from_end, about) * end);
  };
  std::vector<Eigen::Vector2d> through;
  constexpr int pieces = 24;
  for (int i = 0; i <= pieces; ++i) through.push_back(here + on_arc(angle * (i - pieces) / pieces));
  d.on.path(layer::axes, through, "arc", std::abs(angle) * radius > 12 ? 7 : 0);
  d.on.line(layer::lines, here, here + 1.35 * on_arc(-angle), "dashed");
  d.on.line(layer::lines, here, here + 1.35 * on_arc(0), "pale");
  d.on.label(here + on_arc(-angle / 2), on_arc(-angle / 2),
             typeset(d.name_of_size(d.mechanism().frames[f].angle)), "angle");
}

inline void draw_angles(drawing& d) {
  std::vector<int> arcs(d.at.points.size(), 0); // at each point
  for (int f = 1; f < d.mechanism().frames.size(); ++f) {
    const int place = d.place_of_frame[static_cast<std::size_t>(f)];
    if (place == mechanics::none || d.at.rotation_axes[static_cast<std::size_t>(f)].isZero() ||
        d.mechanism().frames[f].angle.is_constant() || d.bent_by.turn(d.mechanism().frames[f]))
      continue;
    draw_angle(d, f, place, 0.55 * detail::axis_length + 9 * arcs[static_cast<std::size_t>(place)]++);
  }
}

} // namespace kanexpr::figures
