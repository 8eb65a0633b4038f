#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/values.hpp>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace kanexpr {

/// The options of `draw`.
struct figure_options {
  std::string title{};                     ///< read aloud to readers who do not see the figure
  std::optional<Eigen::Vector3d> upward{}; ///< in inertial axes; by default opposite to gravity
  std::optional<Eigen::Vector3d>
      eye{}; ///< the direction to the eye; by default perpendicular to a plane of motion
  bool axes = true, angles = true, lengths = true, loads = true, names = true; ///< what is drawn
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
  KANEXPR_ENGINE status write(const std::string& file) const;

private:
  std::string svg_{}, cause_{};
};

/// Draws a model at a state as a textbook does: points, axes, bodies, lengths, angles and loads, with the
/// names that the model gives them. Parameters need values, inputs do not.
KANEXPR_ENGINE figure draw(model& m, given_state<model> x = {}, given_parameters<model> p = {},
                           given_inputs<model> r = {}, const figure_options& how = {});

/// Draws a system at a state: `draw<System>({{q, 0.5}}, {{l, 1}})`.
template <class System>
figure draw(given_state<model> x = {}, given_parameters<model> p = {}, given_inputs<model> r = {},
            const figure_options& how = {}) {
  model m = derive<System>();
  return draw(m, std::move(x), std::move(p), std::move(r), how);
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/figures/figure.ipp>
#endif
