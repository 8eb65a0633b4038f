#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>
#include <Eigen/QR>

#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace playground {

/// A model at a state that moves: its rates, energies, positions and constraints as numbers.
class moving_model {
  using quantity = kanexpr::mechanics::quantity;
  using function = kanexpr::runtime::interpreted<double>;

public:
  moving_model(kanexpr::model& m, const std::map<std::string, double>& start)
      : known_(m.known()), x(symbols(0, states(), start)), p(symbols(states(), known_->parameters, start)),
        r(symbols(states() + known_->parameters, known_->inputs, start)), rhs_(m.function(m.rhs())),
        energies_(m.function(energies(m))), positions_(m.function(positions(m))),
        residual_(m.function(m.configuration_residual())),
        jacobian_(m.function(m.get(quantity::configuration_jacobian_by_all))),
        speed_residual_(m.function(m.velocity_residual())),
        speed_jacobian_(m.function(m.constraint_jacobian())) {}

private:
  std::shared_ptr<const kanexpr::derivation::survey> known_;

public:
  double t = 0;
  Eigen::VectorXd x, p, r; ///< the state, the parameters and the inputs

  const kanexpr::derivation::survey& known() const { return *known_; }
  int coordinates() const { return known_->coordinates; }
  int states() const { return known_->coordinates + known_->speeds; }

  /// Kinetic and potential energy in J.
  Eigen::Vector2d energy() { return energies_(t, x, p, r); }
  /// The positions of all points from their origins, in inertial axes.
  Eigen::Matrix3Xd points() {
    const Eigen::VectorXd all = positions_(t, x, p, r);
    return Eigen::Map<const Eigen::Matrix3Xd>(all.data(), 3, all.size() / 3);
  }

  /// Integrates over a duration with steps of equal length, at most `longest`, of the classical Runge-Kutta
  /// method. Returns why the motion ends; empty if it continues.
  std::string advance(double duration, double longest) {
    const int steps = static_cast<int>(std::ceil(duration / longest));
    for (int i = 0; i < steps; ++i) {
      step(duration / steps);
      if (!x.allFinite()) return cause_.empty() ? "the state is not finite" : cause_;
    }
    return "";
  }

  /// Moves the state onto the constraints and returns whether a consistent state was found nearby. Dependent
  /// coordinates and speeds change; with `reluctance`, the others change as well, by a smaller weight, so
  /// that the motion passes positions at which the dependent ones are not determined.
  bool satisfy_constraints(double reluctance = 1e-3) {
    constexpr int most_iterations = 60;
    constexpr double tolerance = 1e-11, enough = 1e-6;
    double error = 0;
    for (int i = 0; i < most_iterations && known_->configuration_constraints > 0; ++i) {
      const Eigen::VectorXd e = residual_(t, x, p, r);
      error = e.lpNorm<Eigen::Infinity>();
      if (error < tolerance) break;
      x.head(coordinates()) -= weighted_solution(jacobian_(t, x, p, r), e, 0, reluctance);
    }
    if (known_->constraints > 0) {
      const Eigen::VectorXd e = speed_residual_(t, x, p, r);
      x.tail(known_->speeds) -= weighted_solution(speed_jacobian_(t, x, p, r), e, coordinates(), reluctance);
    }
    return x.allFinite() && error < enough && satisfies_velocity_constraints(enough);
  }

  /// Completes the initial values: the independent ones stay as they are if this is possible.
  bool start() {
    const Eigen::VectorXd given = x;
    if (satisfy_constraints(0)) return true;
    x = given;
    return satisfy_constraints(1);
  }

  /// Moves the coordinates so that a point comes closer to a target in the plane of two unit vectors, and
  /// stops the motion.
  void drag(int point, const Eigen::Matrix<double, 2, 3>& plane, const Eigen::Vector2d& target) {
    constexpr int iterations = 6;
    x.tail(known_->speeds).setZero();
    for (int i = 0; i < iterations; ++i) {
      const Eigen::VectorXd before = x;
      const Eigen::Vector2d missing = target - plane * points().col(point);
      Eigen::MatrixXd motion = plane * motion_of(point);
      if (known_->configuration_constraints > 0) motion *= free_directions();
      const Eigen::Matrix2d damped =
          motion * motion.transpose() + 1e-4 * motion.squaredNorm() * Eigen::Matrix2d::Identity();
      if (!(motion.squaredNorm() > 1e-24)) return;
      Eigen::VectorXd change = motion.transpose() * damped.ldlt().solve(missing);
      if (const double largest = change.lpNorm<Eigen::Infinity>(); largest > 0.5) change *= 0.5 / largest;
      x.head(coordinates()) += change;
      if (!satisfy_constraints()) x = before;
    }
    x.tail(known_->speeds).setZero();
    satisfy_constraints();
  }

private:
  using symbols_of_model = std::map<std::string, double>;

  Eigen::VectorXd symbols(int first, int count, const symbols_of_model& start) const {
    Eigen::VectorXd values(count);
    for (int i = 0; i < count; ++i) {
      const auto given = start.find(std::string(known_->names[first + i].view()));
      values(i) = given == start.end() ? (first >= states() && first < states() + known_->parameters ? 1 : 0)
                                       : given->second;
    }
    return values;
  }

  static kanexpr::symbolic::matrix energies(kanexpr::model& m) {
    kanexpr::symbolic::matrix both(m.graph(), 2, 1);
    both(0, 0) = m.get(quantity::kinetic_energy)(0, 0);
    both(1, 0) = m.get(quantity::potential_energy)(0, 0);
    return both;
  }

  static kanexpr::symbolic::matrix positions(kanexpr::model& m) {
    const kanexpr::mechanics::mechanism& of = m.mechanism();
    kanexpr::symbolic::matrix all(m.graph(), 3 * of.points.size(), 1);
    for (int i = 0; i < of.points.size(); ++i) {
      const auto v = kanexpr::mechanics::position_from(of, kanexpr::mechanics::origin_of(of, i), i);
      const auto inertial = kanexpr::mechanics::express(of, v, kanexpr::mechanics::mechanism::inertial);
      for (int axis = 0; axis < 3; ++axis) all(3 * i + axis, 0) = inertial[axis];
    }
    return all;
  }

  Eigen::VectorXd rate(double at, const Eigen::VectorXd& state) {
    Eigen::VectorXd found = rhs_(at, state, p, r);
    if (!found.allFinite()) cause_ = rhs_.status().cause();
    return found;
  }

  void step(double h) {
    const Eigen::VectorXd a = rate(t, x), b = rate(t + h / 2, x + h / 2 * a),
                          c = rate(t + h / 2, x + h / 2 * b), d = rate(t + h, x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
    t += h;
    if (known_->constraints > 0) satisfy_constraints();
  }

  /// Whether J u + b = 0 holds to a part of the size of its terms.
  bool satisfies_velocity_constraints(double part) {
    if (known_->constraints == 0) return true;
    constexpr double rounding = 1e-12;
    Eigen::VectorXd at_rest = x;
    at_rest.tail(known_->speeds).setZero();
    const Eigen::VectorXd error = speed_residual_(t, x, p, r), b = speed_residual_(t, at_rest, p, r);
    const Eigen::MatrixXd j = speed_jacobian_(t, x, p, r);
    const Eigen::VectorXd terms = j.cwiseAbs() * x.tail(known_->speeds).cwiseAbs() + b.cwiseAbs();
    return error.lpNorm<Eigen::Infinity>() <= part * terms.lpNorm<Eigen::Infinity>() + rounding;
  }

  /// The solution of J z = e of least weighted norm, in which dependent symbols are nearly free to change.
  Eigen::VectorXd weighted_solution(const Eigen::MatrixXd& j, const Eigen::VectorXd& e, int first,
                                    double reluctance) const {
    Eigen::VectorXd weights(j.cols());
    for (int i = 0; i < weights.size(); ++i) weights(i) = known_->dependent[first + i] ? 1 : reluctance;
    const Eigen::MatrixXd scaled = j * weights.asDiagonal();
    return weights.asDiagonal() * scaled.completeOrthogonalDecomposition().solve(e);
  }

  /// The derivatives of the position of a point with respect to the coordinates.
  Eigen::Matrix3Xd motion_of(int point) {
    constexpr double h = 1e-6;
    Eigen::Matrix3Xd columns(3, coordinates());
    for (int i = 0; i < coordinates(); ++i) {
      const double q = x(i);
      x(i) = q + h;
      const Eigen::Vector3d after = points().col(point);
      x(i) = q - h;
      columns.col(i) = (after - points().col(point)) / (2 * h);
      x(i) = q;
    }
    return columns;
  }

  /// The projection onto the directions in which the coordinates may move.
  Eigen::MatrixXd free_directions() {
    const Eigen::MatrixXd j = jacobian_(t, x, p, r);
    return Eigen::MatrixXd::Identity(j.cols(), j.cols()) - j.completeOrthogonalDecomposition().solve(j);
  }

  function rhs_, energies_, positions_, residual_, jacobian_, speed_residual_, speed_jacobian_;
  std::string cause_{};
};

} // namespace playground
