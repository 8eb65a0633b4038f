#pragma once

#include <kanexpr/figures/drawing.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kanexpr::figures {

namespace detail {

inline constexpr double axis_length = 46; ///< in pixels
inline constexpr int no_axis = -1;

/// The only component of a vector that is not zero, if there is exactly one.
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

/// The frame of all components of a vector; none if there are several.
inline int frame_of(const mechanics::vector& v) {
  int frame = mechanics::none;
  for (const mechanics::vector::part& part : v.parts) {
    if (part.value.is_zero()) continue;
    if (frame != mechanics::none && frame != part.frame) return mechanics::none;
    frame = part.frame;
  }
  return frame;
}

/// A unit vector perpendicular to another one.
inline Eigen::Vector3d across(const Eigen::Vector3d& v) {
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return v.cross(Eigen::Vector3d::Unit(least)).normalized();
}

} // namespace detail

inline drawing::drawing(const mechanics::multibody_system& s, const geometry& g, const view& v)
    : system(s), at(g), seen(v), scale(230 / g.size) {
  const mechanics::mechanism& m = s.mechanism;
  place_of_frame.assign(static_cast<std::size_t>(m.frames.size()), mechanics::none);
  const auto place = [&](int frame, int point) {
    if (frame == mechanics::none || point == mechanics::none) return;
    int& where = place_of_frame[static_cast<std::size_t>(frame)];
    if (where == mechanics::none) where = point;
  };
  for (int i = 0; i < m.points.size(); ++i)
    if (m.points[i].parent == mechanics::none) place(mechanics::mechanism::inertial, i);
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

inline std::string drawing::name_of(const symbolic::expression& e) const { return symbolic::print(e); }

inline bool drawing::has_links(int frame) const {
  for (const mechanics::point& p : mechanism().points)
    if (p.parent != mechanics::none && detail::frame_of(p.offset) == frame) return true;
  return false;
}

/// A body without links is drawn as the silhouette of the homogeneous body with the same mass and inertia: an
/// ellipsoid, a disc or a rod.
inline void drawing::draw_bodies() {
  const mechanics::mechanism& m = mechanism();
  for (int i = 0; i < m.bodies.size(); ++i) {
    if (m.bodies[i].frame != mechanics::none && has_links(m.bodies[i].frame)) continue;
    const double mass = at.masses[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d& inertia = at.inertias[static_cast<std::size_t>(i)];
    if (m.bodies[i].frame == mechanics::none || !(mass > 0) || !inertia.allFinite() || inertia.isZero())
      continue;
    const Eigen::Matrix3d moments =
        (0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia) / mass; // Σ m r rᵀ / Σ m
    const double largest = moments.diagonal().maxCoeff();
    const int dimensions = static_cast<int>(((moments.diagonal().array() > 1e-6 * largest)).count());
    const double per_dimension = dimensions >= 3 ? 5 : dimensions == 2 ? 4 : 3;
    Eigen::Matrix<double, 2, 3> project;
    project << seen.right.transpose(), seen.up.transpose();
    Eigen::Matrix2d silhouette = per_dimension * scale * scale * project * moments * project.transpose();
    silhouette.diagonal().array() += 16; // visible if it is thin
    on.ellipse(layer::bodies, picture(m.bodies[i].center), silhouette, "volume " + color_of_body(i));
  }
}

inline void drawing::draw_links(bool with_lengths) {
  const mechanics::mechanism& m = mechanism();
  for (int i = 0; i < m.points.size(); ++i) {
    const mechanics::point& p = m.points[i];
    if (p.parent == mechanics::none) continue;
    const Eigen::Vector2d from = picture(p.parent), to = picture(i);
    if ((to - from).norm() < 1) continue;
    const int frame = detail::frame_of(p.offset), body = frame > 0 ? body_of_frame(frame) : mechanics::none;
    const bool is_rigid = frame > 0;
    if (body != mechanics::none) on.line(layer::bodies, from, to, "solid " + color_of_body(body));
    on.line(layer::lines, from, to, is_rigid ? "rod" : "dashed");
    const detail::single_component along = detail::single_component_of(p.offset);
    if (!with_lengths || along.axis == detail::no_axis || along.value.is_constant()) continue;
    const Eigen::Vector2d direction = (to - from).normalized();
    on.label((from + to) / 2, {-direction(1), direction(0)}, typeset(name_of(along.value)), "length");
  }
}

inline void drawing::draw_points(bool with_names) {
  const mechanics::mechanism& m = mechanism();
  std::vector<bool> is_center(static_cast<std::size_t>(m.points.size()));
  const auto label = [&](int p, const std::string& called) {
    if (with_names) on.label(picture(p), {0.8, -0.8}, typeset(called), "name");
  };
  for (int i = 0; i < m.bodies.size(); ++i) {
    const mechanics::body& b = m.bodies[i];
    const Eigen::Vector2d here = picture(b.center);
    if (b.frame == mechanics::none) {
      on.circle(layer::marks, here, 6, "filled " + color_of_body(i));
    } else { // the sign of a mass center
      on.circle(layer::marks, here, 5, "hollow");
      for (const double side : {1.0, -1.0})
        on.path(layer::marks,
                {here, here + Eigen::Vector2d(0, 5 * side), here + Eigen::Vector2d(3.5 * side, 3.5 * side),
                 here + Eigen::Vector2d(5 * side, 0), here},
                "filled");
    }
    is_center[static_cast<std::size_t>(b.center)] = true;
    label(b.center, std::string(b.called.view()));
  }
  for (int i = 0; i < m.points.size(); ++i) {
    if (m.points[i].parent == mechanics::none) { // fixed to the ground
      const Eigen::Vector2d here = picture(i);
      on.line(layer::lines, here + Eigen::Vector2d(-16, -9), here + Eigen::Vector2d(16, -9), "pale");
      for (int k = -3; k <= 3; ++k)
        on.line(layer::lines, here + Eigen::Vector2d(5 * k, -9), here + Eigen::Vector2d(5 * k - 4, -14),
                "pale");
    }
    if (is_center[static_cast<std::size_t>(i)]) continue;
    on.circle(layer::marks, picture(i), 3, "hollow");
    label(i, std::string(m.points[i].called.view()));
  }
}

inline void drawing::draw_axes() {
  const mechanics::mechanism& m = mechanism();
  for (int f = 0; f < m.frames.size(); ++f) {
    const int place = place_of_frame[static_cast<std::size_t>(f)];
    if (place == mechanics::none) continue;
    const Eigen::Vector2d here = picture(place);
    const double length = detail::axis_length * (f == 0 ? 1.2 : 1);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d direction = axes(f).col(axis);
      const Eigen::Vector2d seen_along = seen(direction);
      const std::string called = std::string(m.frames[f].called.view()) + '.' + std::string(1, "xyz"[axis]);
      if (seen_along.norm() < 0.05) {
        if (f != 0) continue;
        const Eigen::Vector2d aside = here + Eigen::Vector2d(-18, 12);
        on.circle(layer::axes, aside, 5, "hollow");
        if (seen.toward_eye(direction) > 0) {
          on.circle(layer::axes, aside, 1.2, "filled");
        } else {
          on.line(layer::axes, aside + Eigen::Vector2d(-3.5, -3.5), aside + Eigen::Vector2d(3.5, 3.5),
                  "axis");
          on.line(layer::axes, aside + Eigen::Vector2d(-3.5, 3.5), aside + Eigen::Vector2d(3.5, -3.5),
                  "axis");
        }
        on.label(aside, {-1, 0.3}, typeset(called), "name");
        continue;
      }
      on.arrow(layer::axes, here, here + length * seen_along,
               f == 0 ? "axis"
                      : "axis " + (body_of_frame(f) == mechanics::none ? std::string("pale")
                                                                       : color_of_body(body_of_frame(f))));
      on.label(here + length * seen_along, seen_along, typeset(called), "name");
    }
  }
}

inline void drawing::draw_angles() {
  const mechanics::mechanism& m = mechanism();
  std::vector<int> arcs(static_cast<std::size_t>(m.points.size()), 0);
  for (int f = 1; f < m.frames.size(); ++f) {
    const mechanics::frame& frame = m.frames[f];
    const bool turns =
        frame.kind == mechanics::orientation::about_basis || frame.kind == mechanics::orientation::about_axis;
    const int place = place_of_frame[static_cast<std::size_t>(f)];
    if (!turns || frame.angle.is_constant() || place == mechanics::none) continue;
    int from_axis = detail::no_axis; // the axis along which the frame's first offset goes
    for (const mechanics::point& p : m.points) {
      const detail::single_component along = detail::single_component_of(p.offset);
      if (along.frame == f && from_axis == detail::no_axis) from_axis = along.axis;
    }
    if (frame.kind == mechanics::orientation::about_basis &&
        (from_axis == detail::no_axis || from_axis == frame.axis))
      from_axis = (frame.axis + 1) % 3;
    const Eigen::Vector3d about = frame.kind == mechanics::orientation::about_basis
                                      ? Eigen::Vector3d(axes(frame.parent).col(frame.axis))
                                      : Eigen::Vector3d(Eigen::Vector3d::Zero());
    if (about.isZero()) continue;
    const Eigen::Vector3d start = axes(frame.parent).col(from_axis), across = about.cross(start);
    const double angle = std::remainder(at.angles[static_cast<std::size_t>(f)], 2 * std::numbers::pi);
    const double radius = 0.55 * detail::axis_length + 9 * arcs[static_cast<std::size_t>(place)]++;
    const Eigen::Vector2d here = picture(place);
    const auto on_arc = [&](double a) -> Eigen::Vector2d {
      return here + radius * seen(std::cos(a) * start + std::sin(a) * across);
    };
    std::vector<Eigen::Vector2d> through;
    constexpr int pieces = 24;
    for (int i = 0; i <= pieces; ++i) through.push_back(on_arc(angle * i / pieces));
    on.path(layer::axes, through, "arc", std::abs(angle) * radius > 12 ? 7 : 0);
    on.line(layer::lines, here, here + 1.35 * radius * seen(start), "dashed");
    on.line(layer::lines, here,
            here + 1.35 * radius * seen(std::cos(angle) * start + std::sin(angle) * across), "pale");
    const Eigen::Vector2d middle = on_arc(angle / 2);
    on.label(middle, middle - here, typeset(name_of(frame.angle)), "angle");
  }
}

inline void drawing::draw_loads() {
  const auto label = [&](const mechanics::vector& value, std::string_view otherwise) {
    const detail::single_component along = detail::single_component_of(value);
    const std::string text = along.axis == detail::no_axis ? std::string(otherwise) : name_of(along.value);
    return typeset(text.size() > 24 ? std::string_view(otherwise) : std::string_view(text));
  };
  for (int i = 0; i < system.loads.forces.size(); ++i) {
    const mechanics::force& each = system.loads.forces[i];
    const Eigen::Vector2d along = seen(at.forces[static_cast<std::size_t>(i)].normalized());
    if (along.norm() < 0.05) continue;
    const Eigen::Vector2d here = picture(each.point), tip = here + 58 * along;
    on.arrow(layer::axes, here, tip, "load");
    on.label(tip, along, label(each.value, "F"), "load");
  }
  for (int i = 0; i < system.loads.torques.size(); ++i) {
    const mechanics::torque& each = system.loads.torques[i];
    const int place = place_of_frame[static_cast<std::size_t>(each.frame)];
    const Eigen::Vector3d about = at.torques[static_cast<std::size_t>(i)].normalized();
    if (place == mechanics::none || about.isZero()) continue;
    const Eigen::Vector3d start = detail::across(about), across = about.cross(start);
    std::vector<Eigen::Vector2d> through;
    for (int k = 0; k <= 24; ++k) {
      const double a = (0.3 + 1.2 * k / 24) * std::numbers::pi;
      through.push_back(picture(place) + 20 * seen(std::cos(a) * start + std::sin(a) * across));
    }
    on.path(layer::axes, through, "load", 8);
    on.label(through[12], through[12] - picture(place), label(each.value, "τ"), "load");
  }
  for (const mechanics::spring_damper& each : system.loads.spring_dampers) {
    const Eigen::Vector2d from = picture(each.point), to = picture(each.other), along = to - from;
    if (along.norm() < 4) continue;
    const Eigen::Vector2d aside = 6 * Eigen::Vector2d(-along(1), along(0)).normalized();
    if (!each.stiffness.is_zero()) {
      std::vector<Eigen::Vector2d> zigzag{from, from + 0.15 * along};
      for (int k = 0; k < 9; ++k)
        zigzag.push_back(from + (0.19 + 0.0775 * k) * along + (k % 2 == 0 ? 1 : -1) * aside);
      zigzag.push_back(from + 0.85 * along), zigzag.push_back(to);
      on.path(layer::axes, zigzag, "load");
      on.label((from + to) / 2, 2 * aside, typeset(name_of(each.stiffness)), "load");
    }
    if (!each.damping.is_zero()) {
      const Eigen::Vector2d shift =
          each.stiffness.is_zero() ? Eigen::Vector2d::Zero().eval() : (-2.6 * aside).eval();
      on.line(layer::axes, from + shift, from + 0.5 * along + shift, "load");
      on.line(layer::axes, from + 0.5 * along + 0.8 * aside + shift, from + 0.5 * along - 0.8 * aside + shift,
              "load");
      on.path(layer::axes,
              {from + 0.42 * along + aside + shift, from + 0.62 * along + aside + shift,
               from + 0.62 * along - aside + shift, from + 0.42 * along - aside + shift},
              "load");
      on.line(layer::axes, from + 0.62 * along + shift, to + shift, "load");
      on.label((from + to) / 2 + shift, -2 * aside, typeset(name_of(each.damping)), "load");
    }
  }
}

inline void drawing::draw_gravity() {
  const Eigen::Vector2d along = seen(at.gravity.normalized());
  if (along.norm() < 0.05) return;
  const detail::single_component value = detail::single_component_of(system.loads.gravity);
  const Eigen::Vector2d from(on.most()(0) + 26, on.most()(1) - 6), to = from + 44 * along;
  on.arrow(layer::axes, from, to, "load");
  std::string called = value.axis == detail::no_axis ? "g" : name_of(value.value);
  if (called.starts_with('-')) called.erase(0, 1);
  on.label((from + to) / 2, {1, 0}, typeset(called), "load");
}

} // namespace kanexpr::figures
