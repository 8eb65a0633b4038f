#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/check_animation.hpp>
#include <kanexpr/animate/default_shapes.hpp>
#include <kanexpr/animate/recorded_outlines.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/animate/rigid_parts.hpp>
#include <kanexpr/animate/rolling.hpp>
#include <kanexpr/animate/undeformed_placements.hpp>
#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/view.hpp>
#include <kanexpr/mechanics/loads/force_and_torque.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace animate {

template <class Trajectory>
recorded_motion motion_of(const Trajectory& trajectory) {
  const auto copied = [](const auto& values) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
  };
  recorded_motion motion;
  motion.parameters = copied(trajectory.parameters());
  for (const auto& sample : trajectory) {
    motion.times.push_back(sample.t);
    motion.states.push_back(copied(sample.x));
    motion.inputs.push_back(copied(sample.r));
  }
  return motion;
}

/// The direction of gravity, or of constant forces on mass centers, which represent weights; else zero.
inline Eigen::Vector3d weight_of(model& m, const figures::geometry& first, const figures::geometry& last) {
  Eigen::Vector3d sum = first.gravity;
  const mechanics::multibody_system& system = m.system();
  for (int i = 0; i < system.loads.forces.size() && first.gravity.isZero(); ++i) {
    const mechanics::force& each = system.loads.forces[i];
    bool is_weight = false;
    for (const mechanics::body& b : system.mechanism.bodies) is_weight = is_weight || b.center == each.point;
    each.value.each_entry([&](symbolic::expression e) { is_weight = is_weight && mechanics::is_fixed(e); });
    const auto which = static_cast<std::size_t>(i);
    if (is_weight && first.forces[which].isApprox(last.forces[which], 1e-9)) sum += first.forces[which];
  }
  return sum.stableNormalized();
}

/// Shows a planar system from in front of its plane, a little from above and from the right.
inline void choose_view(animation& a, const figures::geometry& first, const Eigen::Vector3d& weight) {
  const figures::view seen = figures::view_of(first);
  a.up = weight.isZero() ? figures::upward_of(first) : Eigen::Vector3d(-weight);
  if (!seen.is_planar || std::abs(a.up.dot(seen.eye)) > 0.5) return;
  a.seen_from = (seen.eye + 0.35 * seen.right + 0.22 * seen.up).normalized();
}

/// Adds the shapes that a model has by default.
inline void add_default_shapes(animation& a, model& m, const recorded_motion& motion,
                               const figures::geometry& first) {
  const rigid_parts parts(m.mechanism());
  const recorded_poses poses(m, parts, motion);
  if (!poses.cause().empty()) a.failure = poses.cause() + at_time(motion.times[poses.failed_at()]);
  if (!a) return;
  const figures::geometry last = figures::geometry_of(m, motion.times.back(), motion.states.back(),
                                                      motion.parameters, motion.inputs.back());
  const Eigen::Vector3d weight = weight_of(m, first, last);
  choose_view(a, first, weight);
  const recorded_outlines flexible = record_outlines(m, motion);
  default_shapes shapes(m.system(), parts, poses, flexible, first);
  shapes.add_to(a, !weight.isZero());
  if (const straight_piece* const rolling = shapes.rolling_link())
    move_with_rolling(a, m, rolling->to, motion, poses);
  if (a.shapes.empty()) a.failure = "the model has no bodies, joints or springs to show";
}

inline std::span<const double> numbers_in(const Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// The reason why the vectors of a sample do not have the sizes of the model; empty if they do.
inline std::string check_sizes(const derivation::survey& known, const recorded_motion& motion,
                               std::size_t sample) {
  const auto mistake_in = [&](const char* what, Eigen::Index given, int wanted, const char* symbols) {
    if (given == wanted) return std::string();
    return "the " + (what + at_time(motion.times[sample])) + " has " + std::to_string(given) +
           (given == 1 ? " entry" : " entries") + ", but the model has " + std::to_string(wanted) + symbols +
           (wanted == 1 ? "" : "s");
  };
  std::string mistake = mistake_in("state", motion.states[sample].size(), known.coordinates + known.speeds,
                                   " coordinates and speed");
  if (mistake.empty())
    mistake = mistake_in("input vector", motion.inputs[sample].size(), known.inputs, " input");
  return mistake;
}

/// The same motion without deformations of flexible bodies.
inline recorded_motion without_deformation(const mechanics::mechanism& m, recorded_motion motion) {
  for (const mechanics::flexible_body& b : m.flexible_bodies)
    for (const symbolic::expression& q : b.amplitudes)
      for (Eigen::VectorXd& state : motion.states) state[m.coordinates.find(q)] = 0;
  return motion;
}

/// Returns the default picture of a model along a motion as it is given.
inline animation film_as_given(model m, const recorded_motion& motion) {
  animation a;
  a.failure = m.mistake();
  if (!a) return a;
  const mechanics::unit_table units = m.known()->states_units ? m.units() : mechanics::unit_table();
  a.columns = columns_of(*m.known(), units.is_stated ? &units : nullptr);
  for (std::size_t k = 0; k < motion.times.size() && a; ++k) {
    a.failure = check_sizes(*m.known(), motion, k);
    if (a) add_sample(a, motion.times[k], numbers_in(motion.states[k]), numbers_in(motion.inputs[k]));
  }
  if (a && motion.times.empty()) a.failure = "the trajectory has no samples";
  if (!a) return a;
  drop_unset_inputs(a);
  const figures::geometry first =
      figures::geometry_of(m, motion.times[0], motion.states[0], motion.parameters, motion.inputs[0]);
  a.failure = first.cause;
  if (!a) return a;
  add_default_shapes(a, m, motion, first);
  if (a) a.failure = check_numbers(a);
  return a;
}

/// Returns the default picture of a model along a motion, and the places of its shapes without deformations.
inline animation film(const model& m, const recorded_motion& motion) {
  animation a = film_as_given(m, motion);
  const mechanics::mechanism& of = m.mechanism();
  if (!a || of.flexible_bodies.empty()) return a;
  const animation straight = film_as_given(m, without_deformation(of, motion));
  if (!straight || straight.shapes.size() != a.shapes.size()) return a;
  for (std::size_t i = 0; i < a.shapes.size(); ++i)
    if (straight.shapes[i].name == a.shapes[i].name && straight.shapes[i].kind == a.shapes[i].kind)
      a.shapes[i].undeformed = undeformed_placements(a.shapes[i], straight.shapes[i].placements);
  return a;
}

} // namespace animate

/// The default picture of a system, for `animated` and `write_page`: `write_page<picture_of<System>>(path,
/// trajectory)`. The shapes follow from the frames, points, bodies and springs of the model. The system is
/// derived at run time, so the picture adds little to the compile time.
template <class System_>
struct picture_of {
  using System = System_;

  template <class Trajectory>
  static animation along(const Trajectory& trajectory) {
    animation made = animate::film(derive<System>(), animate::motion_of(trajectory));
    made.system = type_name<System>();
    return made;
  }
};

/// Returns the default picture of a run-time model along a trajectory.
template <class Trajectory>
animation animated(model m, const Trajectory& trajectory) {
  animation made = animate::film(std::move(m), animate::motion_of(trajectory));
  made.system = "The model"; // its type does not identify it
  return made;
}

/// Writes an animated page with the default picture of a run-time model.
template <class Trajectory>
outcome write_page(const std::string& path, model m, const Trajectory& trajectory,
                   const page_options& options = {}) {
  return animate::write_page(path, animated(std::move(m), trajectory), options);
}

} // namespace kanexpr
