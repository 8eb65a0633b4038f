#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/figures/draw_axes.hpp>
#include <kanexpr/figures/draw_bodies.hpp>
#include <kanexpr/figures/draw_loads.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/values.hpp>

#include <Eigen/Core>

#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace kanexpr {

/// The options of `draw`.
struct figure_options {
  std::string title{};                     ///< read aloud to readers who cannot see the figure
  std::optional<Eigen::Vector3d> upward{}; ///< in inertial axes; by default opposite to gravity
  std::optional<Eigen::Vector3d>
      eye{}; ///< the direction to the eye; by default perpendicular to a plane of motion
  bool axes = true, angles = true, lengths = true, loads = true, names = true; ///< the parts to draw
};

/// A figure as the text of an SVG file, which adapts to light and dark pages.
class figure {
public:
  figure() = default;
  explicit figure(std::string drawn) : svg_(std::move(drawn)) {}
  static figure refused(std::string reason) {
    figure f;
    f.cause_ = std::move(reason);
    return f;
  }

  explicit operator bool() const { return cause_.empty(); }
  /// The reason why there is no figure; empty if there is one.
  const std::string& cause() const { return cause_; }

  const std::string& svg() const { return svg_; }
  /// Writes the file; returns the reason for a failure.
  inline status write(const std::string& file) const;

private:
  std::string svg_{}, cause_{};
};

/// Draws a model at a state as in a textbook: points, axes, bodies, lengths, angles and loads, with the names
/// that the model gives them. All parameters need values; inputs do not.
inline figure draw(model& m, given_state<model> x = {}, given_parameters<model> p = {},
                   given_inputs<model> r = {}, const figure_options& how = {});

/// Draws a system at a state: `draw<System>({{q, 0.5}}, {{l, 1}})`.
template <class System>
figure draw(given_state<model> x = {}, given_parameters<model> p = {}, given_inputs<model> r = {},
            const figure_options& how = {}) {
  model m = derive<System>();
  return draw(m, std::move(x), std::move(p), std::move(r), how);
}

inline status figure::write(const std::string& file) const {
  if (!*this) return status(cause_);
  std::ofstream out(file, std::ios::binary);
  out << svg_;
  out.close();
  return out ? status() : status(base::sentence({"the figure cannot be written to ", file}).view());
}

inline figure draw(model& m, given_state<model> x, given_parameters<model> p, given_inputs<model> r,
                   const figure_options& how) {
  if (const std::string mistake = m.mistake(); !mistake.empty()) return figure::refused(mistake);
  x.read(m.known()), p.read(m.known()), r.read(m.known());
  for (const base::sentence& mistake : {x.mistake, p.mistake})
    if (mistake) return figure::refused(std::string(mistake.view()));
  const figures::geometry at = figures::geometry_of(m, 0, x.values, p.values, r.values);
  if (!at.status) return figure::refused(at.status.cause());
  for (const Eigen::Vector3d& each : at.points)
    if (!each.allFinite())
      return figure::refused("the position of a point is not finite; specify values for all parameters");
  figures::view seen = how.upward ? figures::view_of(at, *how.upward) : figures::view_of(at);
  if (how.eye) seen = figures::detail::view_along(how.eye->normalized(), seen.up);
  figures::drawing shown(m.system(), at, seen);
  figures::draw_bodies(shown);
  figures::draw_links(shown, how.lengths);
  figures::draw_points(shown, how.names);
  if (how.axes) figures::draw_axes(shown);
  if (how.angles) figures::draw_angles(shown);
  if (how.loads) figures::draw_loads(shown), figures::draw_gravity(shown);
  return figure(shown.on.svg(how.title.empty() ? "The model" : how.title));
}

} // namespace kanexpr
