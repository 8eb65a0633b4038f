#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/figures/draw_axes.hpp>
#include <kanexpr/figures/draw_bodies.hpp>
#include <kanexpr/figures/draw_loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/values.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
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
  double deflections = 1; ///< the factor of the amplitudes of flexible bodies, to draw small deformations
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
  constexpr double largest = 1e100, least = 1e-100; // squares of sizes neither overflow nor vanish
  constexpr double least_sine = 1e-3;
  for (const Eigen::Vector3d& each : at.points)
    if (!(each.cwiseAbs().maxCoeff() < largest))
      return "the position of a point is not finite or exceeds 1e100; specify values for all parameters";
  if (at.size < least)
    return "the size of the model is " + base::digits(at.size, 3) + "; it must exceed 1e-100";
  for (const auto& [direction, called] : {std::pair(how.upward, "upward"), std::pair(how.eye, "eye")})
    if (direction && !(direction->allFinite() && direction->stableNorm() > 0))
      return std::string("the direction ") + called + " must be finite and not zero";
  if (!how.eye) return "";
  const Eigen::Vector3d up = (how.upward ? *how.upward : upward_of(at)).stableNormalized();
  if (up.cross(how.eye->stableNormalized()).norm() < least_sine)
    return "the eye is in the up direction; specify a different `upward`";
  return "";
}

/// The configuration constraint that a state violates by more than a figure may show, as a sentence; empty if
/// there is none.
inline std::string violation_at(model& m, const Eigen::VectorXd& x, const Eigen::VectorXd& p,
                                const Eigen::VectorXd& r) {
  constexpr double by_eye = 0.03; // relative; two digits are sufficient for a figure
  const std::string cause = check_consistency(m, x, p, r, 0, by_eye).cause();
  return cause.starts_with("configuration constraint") ? cause : "";
}

/// The given coordinate that differs most from the value that the constraints require, as a sentence; empty
/// if the given coordinates satisfy the constraints together with the others.
inline std::string contradiction_between(model& m, const given_state<model>& x,
                                         const Eigen::VectorXd& required, const Eigen::VectorXd& p,
                                         const Eigen::VectorXd& r) {
  Eigen::VectorXd given = required;
  int worst = 0;
  double largest = 0;
  for (int i = 0; i < m.known()->coordinates; ++i) {
    if (x.is_left_out[static_cast<std::size_t>(i)]) continue;
    given(i) = x.values(i);
    const double difference = std::abs(given(i) - required(i)) / (1 + std::abs(required(i)));
    if (difference > largest) worst = i, largest = difference;
  }
  if (violation_at(m, given, p, r).empty()) return "";
  return "coordinate " + std::string(m.known()->names[worst].view()) + " is given as " +
         base::digits(given(worst), 3) + ", but the constraints require " + base::digits(required(worst), 3);
}

/// Solves the constraints for omitted coordinates and speeds, as a simulation does. Returns the reason if
/// there is no solution, or if the given coordinates contradict a constraint.
inline std::string contradiction_in(model& m, given_state<model>& x, const Eigen::VectorXd& p,
                                    const Eigen::VectorXd& r) {
  if (m.system().constraints.on_configuration.empty()) return "";
  const auto first = x.is_left_out.begin(), end = x.is_left_out.end();
  if (std::find(first, first + m.known()->coordinates, true) == first + m.known()->coordinates) {
    const std::string violation = violation_at(m, x.values, p, r);
    if (!violation.empty() || std::find(first, end, true) == end) return violation;
  }
  Eigen::VectorXd assembled = x.values;
  std::string cause = assemble(m, assembled, p, r).cause();
  if (cause.empty()) cause = contradiction_between(m, x, assembled, p, r);
  if (cause.empty()) x.values = assembled;
  return cause;
}

/// Multiplies the amplitudes of flexible bodies in a state. Loops that contain such bodies do not close then.
inline void multiply_amplitudes(const mechanics::mechanism& m, Eigen::VectorXd& x, double factor) {
  for (const mechanics::flexible_body& b : m.flexible_bodies)
    for (const symbolic::expression& q : b.amplitudes) x[m.coordinates.find(q)] *= factor;
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
  if (!numeric::is_finite(how.deflections))
    return figure::refused("the factor of the deflections must be finite");
  figures::multiply_amplitudes(m.mechanism(), x.values, how.deflections);
  const figures::geometry at = figures::geometry_of(m, 0, x.values, p.values, r.values);
  if (const std::string reason = figures::reason_against(at, how); !reason.empty())
    return figure::refused(reason);
  figures::view seen =
      how.upward ? figures::view_of(at, how.upward->stableNormalized()) : figures::view_of(at);
  if (how.eye)
    seen = figures::detail::view_along(
        how.eye->stableNormalized(), (how.upward ? *how.upward : figures::upward_of(at)).stableNormalized());
  figures::drawing shown(m.system(), at, seen);
  if (const std::string reason = figures::reason_against_bodies(shown); !reason.empty())
    return figure::refused(reason);
  figures::draw_bodies(shown);
  figures::draw_beams(shown);
  figures::draw_nodes(shown);
  figures::draw_links(shown, how.lengths);
  figures::draw_points(shown, how.names);
  if (how.axes) figures::draw_axes(shown);
  if (how.angles) figures::draw_angles(shown);
  if (how.loads) figures::draw_loads(shown), figures::draw_gravity(shown);
  return figure(shown.on.svg(how.title.empty() ? "The model" : how.title));
}

} // namespace kanexpr
