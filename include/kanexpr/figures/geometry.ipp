#pragma once

#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/points.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kanexpr::figures {

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

  status evaluate(double t, const Eigen::VectorXd& x, const Eigen::VectorXd& p, const Eigen::VectorXd& r) {
    symbolic::matrix all(model_.graph(), asked_.size(), 1);
    for (int i = 0; i < asked_.size(); ++i) all(i, 0) = asked_[i];
    auto values = model_.function(all);
    values_ = values(t, x, p, r, Eigen::VectorXd::Zero(model_.mechanism().speeds.size()));
    return values.status();
  }

  double number() { return values_(next_++); }
  Eigen::Vector3d vector() {
    const Eigen::Vector3d v = values_.segment<3>(next_);
    next_ += 3;
    return v;
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

inline Eigen::Vector3d finite_or_zero(const Eigen::Vector3d& v) {
  return v.allFinite() ? v : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// The extent of a cloud of points, and at least that of the bodies.
inline double extent(const geometry& g) {
  Eigen::Vector3d least = Eigen::Vector3d::Zero(), most = least;
  for (const Eigen::Vector3d& p : g.points) least = least.cwiseMin(p), most = most.cwiseMax(p);
  double size = (most - least).maxCoeff();
  for (std::size_t i = 0; i < g.masses.size(); ++i)
    if (g.masses[i] > 0) size = (std::max)(size, 2 * std::sqrt(g.inertias[i].trace() / g.masses[i]));
  return size > 0 && std::isfinite(size) ? size : 1;
}

} // namespace detail

KANEXPR_ENGINE geometry geometry_of(model& m, double t, const Eigen::VectorXd& x, const Eigen::VectorXd& p,
                                    const Eigen::VectorXd& r) {
  const mechanics::multibody_system& system = m.system();
  const mechanics::mechanism& mechanism = system.mechanism;
  detail::evaluation placed(m), loaded(m);
  for (int f = 0; f < mechanism.frames.size(); ++f) {
    for (int axis = 0; axis < 3; ++axis) placed.ask(detail::basis_vector(mechanism, f, axis));
    const mechanics::frame& frame = mechanism.frames[f];
    const bool turns =
        frame.kind == mechanics::orientation::about_basis || frame.kind == mechanics::orientation::about_axis;
    placed.ask(turns ? frame.angle : mechanism.zero());
  }
  for (int i = 0; i < mechanism.points.size(); ++i)
    placed.ask(mechanics::position_from(mechanism, mechanics::origin_of(mechanism, i), i));
  for (const mechanics::body& b : mechanism.bodies) {
    placed.ask(b.mass);
    const mechanics::symmetric inertia =
        b.frame == mechanics::none ? mechanics::symmetric(*mechanism.g)
                                   : mechanics::central_inertia(mechanism, b, mechanics::mechanism::inertial);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) placed.ask(inertia(i, j));
  }
  for (const mechanics::force& each : system.loads.forces) loaded.ask(each.value);
  for (const mechanics::torque& each : system.loads.torques) loaded.ask(each.value);
  if (system.loads.has_gravity) loaded.ask(system.loads.gravity);

  geometry g;
  g.status = placed.evaluate(t, x, p, r);
  for (int f = 0; f < mechanism.frames.size(); ++f) {
    Eigen::Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis) axes.col(axis) = placed.vector();
    g.frames.push_back(axes);
    g.angles.push_back(placed.number());
  }
  for (int i = 0; i < mechanism.points.size(); ++i) g.points.push_back(placed.vector());
  for (int i = 0; i < mechanism.bodies.size(); ++i) {
    g.masses.push_back(placed.number());
    Eigen::Matrix3d inertia;
    for (int row = 0; row < 3; ++row) inertia.row(row) = placed.vector();
    g.inertias.push_back(inertia);
  }
  if (g.status) {
    loaded.evaluate(t, x, p, r); // a load that depends on an unset input is NaN, which is no error
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
