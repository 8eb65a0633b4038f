#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/figures/draw_axes.hpp>
#include <kanexpr/figures/draw_bodies.hpp>
#include <kanexpr/figures/draw_loads.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/values.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <concepts>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace kanexpr {

namespace runtime {
class builder;
}
model derive(const runtime::builder& built);

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
  /// Writes the file; the outcome reports a failure.
  outcome write(const std::string& file) const {
    if (!*this) return outcome(cause_);
    std::ofstream out(file, std::ios::binary);
    out << svg_;
    out.close();
    return out ? outcome() : outcome("the figure cannot be written to " + file);
  }

private:
  std::string svg_{}, cause_{};
};

/// Draws a model at a given state in textbook style: points, axes, bodies, lengths, angles and loads, with
/// the names that the model gives them. All parameters need values; inputs do not. Omitted coordinates that
/// the constraints determine are solved for.
inline figure draw(model m, given_state<model> x = {}, given_parameters<model> p = {},
                   given_inputs<model> r = {}, const figure_options& how = {});

/// Draws the system built so far.
template <std::derived_from<runtime::builder> Builder>
figure draw(const Builder& built, given_state<model> x = {}, given_parameters<model> p = {},
            given_inputs<model> r = {}, const figure_options& how = {}) {
  return draw(derive(built), std::move(x), std::move(p), std::move(r), how);
}

/// Draws a system at a state: `draw<System>({{q, 0.5}}, {{l, 1}})`.
template <class System>
figure draw(given_state<model> x = {}, given_parameters<model> p = {}, given_inputs<model> r = {},
            const figure_options& how = {}) {
  return draw(derive<System>(), std::move(x), std::move(p), std::move(r), how);
}

namespace figures {

/// The reason why a geometry cannot be drawn as requested; empty if it can be.
inline std::string reason_against(const geometry& at, const figure_options& how) {
  if (!at.cause.empty()) return at.cause;
  constexpr double largest = 1e100, least_sine = 1e-3; // squares of sizes do not overflow
  for (const Eigen::Vector3d& each : at.points)
    if (!(each.cwiseAbs().maxCoeff() < largest))
      return "the position of a point is not finite or exceeds 1e100; specify values for all parameters";
  for (const auto& [direction, called] : {std::pair(how.upward, "upward"), std::pair(how.eye, "eye")})
    if (direction && !(direction->allFinite() && direction->stableNorm() > 0))
      return std::string("the direction ") + called + " must be finite and not zero";
  if (!how.eye) return "";
  const Eigen::Vector3d up = (how.upward ? *how.upward : upward_of(at)).stableNormalized();
  if (up.cross(how.eye->stableNormalized()).norm() < least_sine)
    return "the eye is in the up direction; specify a different `upward`";
  return "";
}

/// Solves the configuration constraints for omitted coordinates, as a simulation does. Returns the reason if
/// there is no solution, or if the values of all coordinates are given and contradict a constraint.
inline std::string contradiction_in(model& m, given_state<model>& x, const Eigen::VectorXd& p,
                                    const Eigen::VectorXd& r) {
  constexpr double by_eye = 0.03; // relative; two digits are sufficient for a figure
  if (m.system().constraints.on_configuration.empty()) return "";
  if (std::ranges::find(x.is_left_out, true) == x.is_left_out.end()) {
    const std::string cause = check_consistency(m, x.values, p, r, 0, by_eye).cause();
    return cause.starts_with("configuration constraint") ? cause : "";
  }
  Eigen::VectorXd assembled = x.values;
  const std::string cause = assemble(m, assembled, p, r).cause();
  if (cause.empty()) x.values = assembled;
  return cause;
}

} // namespace figures

inline figure draw(model m, given_state<model> x, given_parameters<model> p, given_inputs<model> r,
                   const figure_options& how) {
  if (const std::string mistake = m.mistake(); !mistake.empty()) return figure::refused(mistake);
  x.read(m.known()), p.read(m.known()), r.read(m.known(), false);
  for (const base::sentence& mistake : {x.mistake, p.mistake, r.mistake})
    if (mistake) return figure::refused(std::string(mistake.view()));
  if (const std::string reason = figures::contradiction_in(m, x, p.values, r.values); !reason.empty())
    return figure::refused(reason);
  const figures::geometry at = figures::geometry_of(m, 0, x.values, p.values, r.values);
  if (const std::string reason = figures::reason_against(at, how); !reason.empty())
    return figure::refused(reason);
  figures::view seen =
      how.upward ? figures::view_of(at, how.upward->stableNormalized()) : figures::view_of(at);
  if (how.eye)
    seen = figures::detail::view_along(
        how.eye->stableNormalized(), (how.upward ? *how.upward : figures::upward_of(at)).stableNormalized());
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
