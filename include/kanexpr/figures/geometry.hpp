#pragma once

#include <kanexpr/figures/outlines.hpp>
#include <kanexpr/figures/pathways.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/numeric/taut_line.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::figures {

/// The positions, orientations and loads of a model at a state, in inertial axes and in the order of the
/// model's lists.
struct geometry {
  std::vector<Eigen::Matrix3d> frames{}; ///< the basis vectors as columns
  std::vector<Eigen::Vector3d>
      rotation_axes{};          ///< the axes about which frames are rotated; zero if a frame has no angle
  std::vector<double> angles{}; ///< relative to the parent frame
  std::vector<Eigen::Vector3d> points{};
  std::vector<std::vector<Eigen::Vector3d>> beams{}; ///< for each beam, the places along its axis
  std::vector<std::vector<Eigen::Vector3d>> nodes{}; ///< of each other flexible body
  std::vector<double> masses{};
  std::vector<Eigen::Matrix3d> inertias{}; ///< about the mass centers; zero for particles
  std::vector<Eigen::Vector3d> forces{}, torques{};
  std::vector<numeric::wrapped_surface> surfaces{}; ///< of each load along a pathway
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  double size = 1; ///< the largest extent of the points along an axis; of the bodies if it is zero

  std::string cause{}; ///< why there is no geometry; empty if there is one
};

namespace detail {

/// Collects expressions, evaluates them with one function, and reads the values in the same order.
class evaluation {
public:
  explicit evaluation(model& m) : model_(m) {}

  void ask(const symbolic::expression& e) { asked_.push(e); }
  void ask(const mechanics::vector& v) {
    const mechanics::components inertial =
        mechanics::express(model_.mechanism(), v, mechanics::mechanism::inertial);
    for (int i = 0; i < 3; ++i) ask(inertial[i]);
  }

  /// Returns the reason why a value does not exist at this state; empty if all exist.
  std::string evaluate(double t, const Eigen::VectorXd& x, const Eigen::VectorXd& p,
                       const Eigen::VectorXd& r) {
    symbolic::matrix all(model_.graph(), asked_.size(), 1);
    for (int i = 0; i < asked_.size(); ++i) all(i, 0) = asked_[i];
    auto values = model_.function(all);
    values_ = values(t, x, p, r, Eigen::VectorXd::Zero(model_.mechanism().speeds.size()));
    return values.status().cause();
  }

  double number() { return values_(next_++); }
  Eigen::Vector3d vector() {
    const Eigen::Vector3d v = values_.segment<3>(next_);
    next_ += 3;
    return v;
  }
  std::vector<Eigen::Vector3d> vectors(std::size_t count) {
    std::vector<Eigen::Vector3d> all;
    all.reserve(count);
    while (all.size() < count) all.push_back(vector());
    return all;
  }

private:
  model& model_;
  base::sequence<symbolic::expression> asked_{};
  Eigen::VectorXd values_{};
  Eigen::Index next_ = 0;
};

inline mechanics::vector basis_vector(const mechanics::mechanism& m, int frame, int axis) {
  mechanics::components unit(*m.g);
  unit[axis] = m.one();
  mechanics::vector v;
  v.add(frame, unit);
  return v;
}

/// The axis about which a frame is rotated relative to its parent; zero if the rotation is not specified by
/// an angle.
inline mechanics::vector axis_of_rotation(const mechanics::mechanism& m, int f) {
  const mechanics::frame& frame = m.frames[f];
  if (frame.kind == mechanics::orientation::about_basis) return basis_vector(m, frame.parent, frame.axis);
  mechanics::vector axis;
  if (frame.kind == mechanics::orientation::about_axis) axis.add(frame.parent, frame.direction);
  return axis;
}

inline Eigen::Vector3d finite_or_zero(const Eigen::Vector3d& v) {
  return v.allFinite() ? v : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// The largest extent of the points along an axis; if it is zero, that of the largest body.
inline double extent(const geometry& g) {
  Eigen::Vector3d least = Eigen::Vector3d::Zero(), most = least;
  for (const Eigen::Vector3d& p : g.points) least = least.cwiseMin(p), most = most.cwiseMax(p);
  for (const auto* bodies : {&g.beams, &g.nodes})
    for (const std::vector<Eigen::Vector3d>& body : *bodies)
      for (const Eigen::Vector3d& p : body) least = least.cwiseMin(p), most = most.cwiseMax(p);
  double size = (most - least).maxCoeff();
  if (size > 0) return size;
  for (std::size_t i = 0; i < g.masses.size(); ++i)
    if (g.masses[i] > 0) size = (std::max)(size, 2 * std::sqrt(g.inertias[i].trace() / g.masses[i]));
  return size > 0 && std::isfinite(size) ? size : 1;
}

} // namespace detail

/// Evaluates the geometry of a model that has no mistakes. Loads that depend on inputs without a value or on
/// accelerations are zero.
inline geometry geometry_of(model& m, double t, const Eigen::VectorXd& x, const Eigen::VectorXd& p,
                            const Eigen::VectorXd& r) {
  const mechanics::multibody_system& system = m.system();
  const mechanics::mechanism& mechanism = system.mechanism;
  const base::sequence<mechanics::path_load> path_loads = system.loads.all<mechanics::path_load>();
  detail::evaluation placed(m), loaded(m);
  for (int f = 0; f < mechanism.frames.size(); ++f) {
    for (int axis = 0; axis < 3; ++axis) placed.ask(detail::basis_vector(mechanism, f, axis));
    const mechanics::vector axis = detail::axis_of_rotation(mechanism, f);
    placed.ask(axis);
    placed.ask(axis.is_zero() ? mechanism.zero() : mechanism.frames[f].angle);
  }
  for (int i = 0; i < mechanism.points.size(); ++i)
    placed.ask(mechanics::position_from(mechanism, mechanics::origin_of(mechanism, i), i));
  const outlined_mechanism drawn(mechanism);
  const std::vector<std::vector<int>> beams = drawn.points_of_beams(), nodes = drawn.points_of_nodes();
  for (const auto* bodies : {&beams, &nodes})
    for (const std::vector<int>& points : *bodies)
      for (const int point : points) placed.ask(mechanics::position_from_origin(drawn.mechanism, point));
  for (const mechanics::body& b : mechanism.bodies) {
    placed.ask(b.mass);
    const mechanics::symmetric inertia =
        b.frame == mechanics::none ? mechanics::symmetric(*mechanism.g)
                                   : mechanics::central_inertia(mechanism, b, mechanics::mechanism::inertial);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) placed.ask(inertia(i, j));
  }
  for (const mechanics::path_load& each : path_loads) {
    if (!each.along.is_around_surface()) continue;
    mechanics::vector axis;
    axis.add(each.along.frame, each.along.surface.axis);
    placed.ask(axis);
    placed.ask(each.along.surface.size);
  }
  for (const mechanics::force& each : system.loads.forces) loaded.ask(each.value);
  for (const mechanics::torque& each : system.loads.torques) loaded.ask(each.value);
  if (system.loads.has_gravity) loaded.ask(system.loads.gravity);

  geometry g;
  g.cause = placed.evaluate(t, x, p, r);
  for (int f = 0; f < mechanism.frames.size(); ++f) {
    Eigen::Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis) axes.col(axis) = placed.vector();
    g.frames.push_back(axes);
    g.rotation_axes.push_back(placed.vector());
    g.angles.push_back(placed.number());
  }
  for (int i = 0; i < mechanism.points.size(); ++i) g.points.push_back(placed.vector());
  for (const std::vector<int>& points : beams) g.beams.push_back(placed.vectors(points.size()));
  for (const std::vector<int>& points : nodes) g.nodes.push_back(placed.vectors(points.size()));
  for (int i = 0; i < mechanism.bodies.size(); ++i) {
    g.masses.push_back(placed.number());
    Eigen::Matrix3d inertia;
    for (int row = 0; row < 3; ++row) inertia.row(row) = placed.vector();
    g.inertias.push_back(inertia);
  }
  for (const mechanics::path_load& each : path_loads) {
    g.surfaces.emplace_back();
    if (!each.along.is_around_surface()) continue;
    const Eigen::Vector3d axis = placed.vector();
    g.surfaces.back() =
        surface_of(each.along, g.points[static_cast<std::size_t>(each.along.center)], axis, placed.number());
  }
  if (g.cause.empty()) {
    loaded.evaluate(t, x, p, r); // a load that depends on an unset input is NaN, which is not an error
    for (int i = 0; i < system.loads.forces.size(); ++i)
      g.forces.push_back(detail::finite_or_zero(loaded.vector()));
    for (int i = 0; i < system.loads.torques.size(); ++i)
      g.torques.push_back(detail::finite_or_zero(loaded.vector()));
    if (system.loads.has_gravity) g.gravity = detail::finite_or_zero(loaded.vector());
  }
  g.size = detail::extent(g);
  return g;
}

} // namespace kanexpr::figures
