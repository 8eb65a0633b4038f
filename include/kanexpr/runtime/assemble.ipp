#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/vector_checks.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/assemble.hpp>

#include <Eigen/Core>

namespace kanexpr::runtime {

/// Provides the constraints of a run-time model to the numerical methods that satisfy them.
class constraints_at {
  using quantity = mechanics::quantity;

  /// The time, parameters and inputs at which the constraints are evaluated.
  struct arguments {
    double t;
    Eigen::Map<const Eigen::VectorXd> p, r;
  };

  /// A result as a function of the state.
  struct function_of_state {
    const arguments& at;
    mutable interpreted<double> result;

    Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return result(at.t, x, at.p, at.r); }
  };

  base::sequence<int> coordinates_, speeds_;
  bool velocities_are_linear_;
  base::sequence<base::sequence<int>> quaternions_;
  const mechanics::mechanism& mechanism_;
  base::sentence far_from_one_{};
  arguments arguments_;

public:
  using coordinate_vector = Eigen::VectorXd;
  using speed_vector = Eigen::VectorXd;
  static constexpr bool only_linear = false;

  constraints_at(model& m, double t, std::span<const double> p, std::span<const double> r)
      : coordinates_(m.equations().coordinates().dependent), speeds_(m.equations().speeds().dependent),
        velocities_are_linear_(m.equations().constraints_used().nonlinear == 0),
        quaternions_(mechanics::unit_quaternions(m.mechanism())), mechanism_(m.mechanism()),
        arguments_{t, vector_of(p), vector_of(r)}, residual(of(m, quantity::configuration_residual)),
        configuration_terms(of(m, quantity::configuration_terms)),
        redundant_residual(of(m, quantity::redundant_residual)),
        redundant_terms(of(m, quantity::redundant_terms)), redundant_rate(of(m, quantity::redundant_rate)),
        redundant_rate_terms(of(m, quantity::redundant_rate_terms)),
        jacobian(m.function(m.get(quantity::configuration_jacobian_by_all))),
        velocity_residual(of(m, quantity::velocity_residual)),
        velocity_terms(of(m, quantity::velocity_terms)), speeds_solved(of(m, quantity::dependent_speeds)),
        by_speeds(
            m.function(velocities_are_linear_ ? symbolic::matrix{} : m.get(quantity::constraint_jacobian))) {}

  // formed in this order, which determines their rounding
  function_of_state residual, configuration_terms, redundant_residual, redundant_terms, redundant_rate,
      redundant_rate_terms;
  interpreted<double> jacobian;
  function_of_state velocity_residual, velocity_terms, speeds_solved;
  interpreted<double> by_speeds;

  int all_coordinates() const { return mechanism_.coordinates.size(); }
  int coordinates() const { return coordinates_.size(); }
  int place_of_coordinate(int i) const { return coordinates_[i]; }

  Eigen::VectorXd configuration_residual(const Eigen::VectorXd& x) { return residual(normalized(x)); }
  Eigen::MatrixXd configuration_jacobian_by_all(const Eigen::VectorXd& x) {
    const Eigen::VectorXd at = normalized(x);
    Eigen::MatrixXd by_all = jacobian(arguments_.t, at, arguments_.p, arguments_.r),
                    by_dependent(by_all.rows(), coordinates());
    for (const base::sequence<int>& places : quaternions_) lower::leave_norm_out(by_all, at, places);
    for (int i = 0; i < coordinates(); ++i) by_dependent.col(i) = by_all.col(coordinates_[i]);
    return by_dependent;
  }
  bool velocities_are_linear() const { return velocities_are_linear_; }
  int dependent_speeds() const { return speeds_.size(); }
  int place_of_speed(int i) const { return all_coordinates() + speeds_[i]; }
  Eigen::MatrixXd velocity_jacobian_by_dependent(const Eigen::VectorXd& x) {
    const Eigen::MatrixXd by_all = by_speeds(arguments_.t, x, arguments_.p, arguments_.r);
    Eigen::MatrixXd by_dependent(by_all.rows(), dependent_speeds());
    for (int i = 0; i < dependent_speeds(); ++i) by_dependent.col(i) = by_all.col(speeds_[i]);
    return by_dependent;
  }
  /// Whether the configuration constraints hold to within rounding.
  bool configuration_holds(const Eigen::VectorXd& x) {
    return numeric::is_within_rounding(configuration_residual(x),
                                       numeric::typical_terms(configuration_terms, x, all_coordinates()));
  }
  bool velocities_hold(const Eigen::VectorXd& x) {
    return numeric::is_within_rounding(velocity_residual(x),
                                       numeric::typical_terms(velocity_terms, x, all_coordinates()));
  }
  /// The residuals (e·e − 1)/2 of the quaternion norms.
  Eigen::VectorXd quaternion_residual(const Eigen::VectorXd& x) const {
    Eigen::VectorXd left(quaternions_.size());
    for (int i = 0; i < quaternions_.size(); ++i) left(i) = (lower::squared_norm(x, quaternions_[i]) - 1) / 2;
    return left;
  }
  base::sentence quaternion_called(int k) const {
    return base::sentence(
        {"the quaternion ",
         mechanics::enumerated(mechanism_, mechanism_.coordinates, quaternions_[k]).view()});
  }
  kanexpr::status normalize_quaternions(Eigen::VectorXd& x) {
    for (int k = 0; k < quaternions_.size(); ++k)
      if (!lower::normalize(x, quaternions_[k], lower::norm_range{})) {
        far_from_one_ = base::sentence({"the norm of ", quaternion_called(k).view(), " is far from 1"});
        return kanexpr::status(far_from_one_.view());
      }
    return {};
  }
  kanexpr::status solve_speeds(Eigen::VectorXd& x) {
    const Eigen::VectorXd u = speeds_solved(x);
    const kanexpr::status solved = speeds_solved.result.status();
    if (solved)
      for (int i = 0; i < speeds_.size(); ++i) x(place_of_speed(i)) = u(i);
    return solved;
  }

private:
  static Eigen::Map<const Eigen::VectorXd> vector_of(std::span<const double> values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  function_of_state of(model& m, quantity wanted) const { return {arguments_, m.function(m.get(wanted))}; }

  Eigen::VectorXd normalized(Eigen::VectorXd x) {
    normalize_quaternions(x);
    return x;
  }
};

/// The reason why the constraints of a model cannot be evaluated at a state with `entries` entries; empty if
/// they can.
inline base::sentence check_constraints(model& m, std::size_t entries) {
  m.get(mechanics::quantity::velocity_residual); // clears the mistake in the previous request
  if (!m.mistake().empty()) return base::sentence({m.mistake()});
  return compiled::check_size("state", "the model", static_cast<int>(entries),
                              m.mechanism().coordinates.size() + m.mechanism().speeds.size());
}

KANEXPR_ENGINE assembly assemble(model& m, std::span<double> x, std::span<const double> p,
                                 std::span<const double> r, double t, const assembly_options& options) {
  if (const base::sentence wrong = check_constraints(m, x.size())) return {.failure = wrong};
  constraints_at constraints(m, t, p, r);
  Eigen::Map<Eigen::VectorXd> given(x.data(), static_cast<Eigen::Index>(x.size()));
  Eigen::VectorXd placed = given;
  const assembly report = numeric::assemble(constraints, placed, options);
  given = placed;
  return report;
}

KANEXPR_ENGINE consistency check_consistency(model& m, std::span<const double> x, std::span<const double> p,
                                             std::span<const double> r, double t, double tolerance) {
  if (const base::sentence wrong = check_constraints(m, x.size())) return {.failure = wrong};
  constraints_at constraints(m, t, p, r);
  const Eigen::VectorXd state =
      Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  return numeric::check_consistency(constraints, state, tolerance);
}

} // namespace kanexpr::runtime
