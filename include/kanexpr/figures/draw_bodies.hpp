#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/figures/drawing.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::figures {

/// Whether a body is drawn as a silhouette.
inline bool has_silhouette(const drawing& d, int body) {
  const int frame = d.mechanism().bodies[body].frame;
  const Eigen::Matrix3d& inertia = d.at.inertias[static_cast<std::size_t>(body)];
  return frame != mechanics::none && !d.has_links(frame) && d.at.masses[static_cast<std::size_t>(body)] > 0 &&
         inertia.allFinite() && !inertia.isZero();
}

/// The reason why a silhouette is too large for a picture; empty if none is.
inline std::string reason_against_bodies(const drawing& d) {
  constexpr double largest = 1e12; // relative to the model
  for (int i = 0; i < d.mechanism().bodies.size(); ++i) {
    if (!has_silhouette(d, i)) continue;
    const auto body = static_cast<std::size_t>(i);
    const double radius = std::sqrt(d.at.inertias[body].cwiseAbs().maxCoeff() / d.at.masses[body]);
    if (!(radius < largest * d.at.size))
      return "the radius of gyration of the body " + std::string(d.mechanism().bodies[i].called.view()) +
             " is " + base::digits(radius, 3) + ", but the size of the model is " +
             base::digits(d.at.size, 3);
  }
  return "";
}

/// A body without links is drawn as the silhouette of a homogeneous body with the same mass and inertia: an
/// ellipsoid, a disc or a rod.
inline void draw_bodies(drawing& d) {
  const mechanics::mechanism& m = d.mechanism();
  for (int i = 0; i < m.bodies.size(); ++i) {
    if (!has_silhouette(d, i)) continue;
    const double mass = d.at.masses[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d& inertia = d.at.inertias[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d moments =
        (0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia) / mass; // Σ m r rᵀ / Σ m
    const Eigen::Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvalues();
    const auto dimensions = (principal.array() > 1e-6 * principal.maxCoeff()).count();
    const double per_dimension = dimensions >= 3 ? 5 : dimensions == 2 ? 4 : 3;
    Eigen::Matrix<double, 2, 3> project;
    project << d.seen.right.transpose(), d.seen.up.transpose();
    Eigen::Matrix2d silhouette = per_dimension * d.scale * d.scale * project * moments * project.transpose();
    silhouette.diagonal().array() += 16; // keeps thin bodies visible
    d.on.ellipse(layer::bodies, d.picture(m.bodies[i].center), silhouette, "volume " + d.color_of_body(i));
  }
}

/// A beam is drawn along its deflected axis.
inline void draw_beams(drawing& d) {
  for (std::size_t i = 0; i < d.at.beams.size(); ++i) {
    std::vector<Eigen::Vector2d> axis;
    axis.reserve(d.at.beams[i].size());
    for (const Eigen::Vector3d& place : d.at.beams[i]) axis.push_back(d.picture(place));
    const int color = d.mechanism().bodies.size() + static_cast<int>(i);
    d.on.path(layer::bodies, axis, "solid " + d.color_of_body(color));
    d.on.path(layer::lines, axis, "rod");
  }
}

/// A flexible body that is given by numbers is drawn as its nodes, connected by short lines.
inline void draw_nodes(drawing& d) {
  for (std::size_t i = 0; i < d.at.nodes.size(); ++i) {
    const std::vector<Eigen::Vector3d>& places = d.at.nodes[i];
    const std::string color =
        d.color_of_body(d.mechanism().bodies.size() + static_cast<int>(d.at.beams.size() + i));
    for (const auto& [from, to] : shortest_connections(places)) {
      d.on.line(layer::bodies, d.picture(places[from]), d.picture(places[to]), "solid " + color);
      d.on.line(layer::lines, d.picture(places[from]), d.picture(places[to]), "rod");
    }
    for (const Eigen::Vector3d& place : places) d.on.circle(layer::marks, d.picture(place), 2, "filled");
  }
}

inline void draw_links(drawing& d, bool with_lengths) {
  const mechanics::mechanism& m = d.mechanism();
  for (int i = 0; i < m.points.size(); ++i) {
    const mechanics::point& p = m.points[i];
    if (p.parent == mechanics::none || d.bent_by.move(p)) continue;
    const Eigen::Vector2d from = d.picture(p.parent), to = d.picture(i);
    if ((to - from).norm() < 1) continue;
    const int frame = detail::frame_of(p.offset), body = frame > 0 ? d.body_of_frame(frame) : mechanics::none;
    const bool is_rigid = frame > 0;
    if (body != mechanics::none) d.on.line(layer::bodies, from, to, "solid " + d.color_of_body(body));
    d.on.line(layer::lines, from, to, is_rigid ? "rod" : "dashed");
    const detail::single_component along = detail::single_component_of(p.offset);
    if (!with_lengths || along.axis == detail::no_axis || along.value.is_constant()) continue;
    const Eigen::Vector2d direction = (to - from).normalized();
    d.on.label((from + to) / 2, {-direction(1), direction(0)}, typeset(d.name_of_size(along.value)),
               "length");
  }
}

/// The symbol for a point that is fixed in the inertial frame.
inline void draw_ground(drawing& d, const Eigen::Vector2d& here) {
  using vector = Eigen::Vector2d;
  d.on.line(layer::lines, here + vector(-16, -9), here + vector(16, -9), "pale");
  for (int k = -3; k <= 3; ++k)
    d.on.line(layer::lines, here + vector(5 * k, -9), here + vector(5 * k - 4, -14), "pale");
}

inline void draw_mass_center(drawing& d, const Eigen::Vector2d& here) {
  using vector = Eigen::Vector2d;
  d.on.circle(layer::marks, here, 5, "hollow");
  for (const double side : {1.0, -1.0})
    d.on.path(
        layer::marks,
        {here, here + side * vector(0, 5), here + side * vector(3.5, 3.5), here + side * vector(5, 0), here},
        "filled");
}

/// Draws bodies at their mass centers and, unless the figure is crowded, the other points.
inline void draw_points(drawing& d, bool with_names) {
  const mechanics::mechanism& m = d.mechanism();
  const auto label = [&](int point, std::string_view called, double radius) {
    if (with_names) d.on.label(d.picture(point), {0.8, -0.8}, typeset(called), "name", radius);
  };
  std::vector<bool> is_center(d.at.points.size());
  for (int i = 0; i < m.bodies.size(); ++i) {
    const mechanics::body& b = m.bodies[i];
    is_center[static_cast<std::size_t>(b.center)] = true;
    if (b.frame == mechanics::none)
      d.on.circle(layer::marks, d.picture(b.center), 6, "filled " + d.color_of_body(i));
    else
      draw_mass_center(d, d.picture(b.center));
    label(b.center, b.called.view(), 6);
  }
  for (int i = 0; i < m.points.size(); ++i) {
    if (m.points[i].parent == mechanics::none) draw_ground(d, d.picture(i));
    if (is_center[static_cast<std::size_t>(i)] || d.is_crowded()) continue;
    d.on.circle(layer::marks, d.picture(i), 3, "hollow");
    label(i, m.points[i].called.view(), 2);
  }
}

} // namespace kanexpr::figures
