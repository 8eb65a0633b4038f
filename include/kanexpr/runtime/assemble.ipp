#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/fitting.hpp>
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
  using given_vector = Eigen::Map<const Eigen::VectorXd>;

public:
  using coordinate_vector = Eigen::VectorXd;

  constraints_at(model& m, double t, std::span<const double> p, std::span<const double> r)
      : coordinates_(m.equations().coordinates().dependent), speeds_(m.equations().speeds().dependent),
        quaternions_(mechanics::unit_quaternions(m.mechanism())), mechanism_(m.mechanism()),
        first_speed_(m.mechanism().coordinates.size()), t_(t), p_(p.data(), size_of(p)),
        r_(r.data(), size_of(r)), residual_(m.function(m.get(mechanics::quantity::configuration_residual))),
        terms_(m.function(m.get(mechanics::quantity::configuration_terms))),
        redundant_(m.function(m.get(mechanics::quantity::redundant_residual))),
        redundant_terms_(m.function(m.get(mechanics::quantity::redundant_terms))),
        redundant_rate_(m.function(m.get(mechanics::quantity::redundant_rate))),
        redundant_rate_terms_(m.function(m.get(mechanics::quantity::redundant_rate_terms))),
        jacobian_(m.function(m.get(mechanics::quantity::configuration_jacobian_by_all))),
        velocity_residual_(m.function(m.get(mechanics::quantity::velocity_residual))),
        velocity_terms_(m.function(m.get(mechanics::quantity::velocity_terms))),
        speeds_solved_(m.function(m.get(mechanics::quantity::dependent_speeds))) {}

  int all_coordinates() const { return first_speed_; }
  int coordinates() const { return coordinates_.size(); }
  int place_of_coordinate(int i) const { return coordinates_[i]; }

  Eigen::VectorXd configuration_residual(const Eigen::VectorXd& x) {
    return residual_(t_, at_norm_one(x), p_, r_);
  }
  Eigen::MatrixXd configuration_jacobian_by_all(const Eigen::VectorXd& x) {
    const Eigen::VectorXd at = at_norm_one(x);
    Eigen::MatrixXd by_all = jacobian_(t_, at, p_, r_), by_dependent(by_all.rows(), coordinates());
    for (const base::sequence<int>& places : quaternions_) lower::leave_norm_out(by_all, at, places);
    for (int i = 0; i < coordinates(); ++i) by_dependent.col(i) = by_all.col(coordinates_[i]);
    return by_dependent;
  }
  Eigen::VectorXd configuration_terms(const Eigen::VectorXd& x) { return terms_(t_, x, p_, r_); }
  Eigen::VectorXd velocity_residual(const Eigen::VectorXd& x) { return velocity_residual_(t_, x, p_, r_); }
  Eigen::VectorXd velocity_terms(const Eigen::VectorXd& x) { return velocity_terms_(t_, x, p_, r_); }
  Eigen::VectorXd redundant_residual(const Eigen::VectorXd& x) { return redundant_(t_, x, p_, r_); }
  Eigen::VectorXd redundant_terms(const Eigen::VectorXd& x) { return redundant_terms_(t_, x, p_, r_); }
  Eigen::VectorXd redundant_rate(const Eigen::VectorXd& x) { return redundant_rate_(t_, x, p_, r_); }
  Eigen::VectorXd redundant_rate_terms(const Eigen::VectorXd& x) {
    return redundant_rate_terms_(t_, x, p_, r_);
  }
  /// Whether the configuration constraints hold to within rounding.
  bool configuration_holds(const Eigen::VectorXd& x) {
    return numeric::is_rounding(
        configuration_residual(x),
        numeric::usual_terms([&](const Eigen::VectorXd& at) { return configuration_terms(at); }, x,
                             all_coordinates()));
  }
  bool velocities_hold(const Eigen::VectorXd& x) {
    return numeric::is_rounding(
        velocity_residual(x),
        numeric::usual_terms([&](const Eigen::VectorXd& at) { return velocity_terms(at); }, x,
                             all_coordinates()));
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
    const Eigen::VectorXd u = speeds_solved_(t_, x, p_, r_);
    if (speeds_solved_.status())
      for (int i = 0; i < speeds_.size(); ++i) x(first_speed_ + speeds_[i]) = u(i);
    return speeds_solved_.status();
  }

private:
  static Eigen::Index size_of(std::span<const double> values) {
    return static_cast<Eigen::Index>(values.size());
  }
  Eigen::VectorXd at_norm_one(Eigen::VectorXd x) {
    normalize_quaternions(x);
    return x;
  }

  base::sequence<int> coordinates_, speeds_;
  base::sequence<base::sequence<int>> quaternions_;
  const mechanics::mechanism& mechanism_;
  base::sentence far_from_one_;
  int first_speed_;
  double t_;
  given_vector p_;
  given_vector r_;
  interpreted<double> residual_, terms_, redundant_, redundant_terms_, redundant_rate_, redundant_rate_terms_,
      jacobian_, velocity_residual_, velocity_terms_, speeds_solved_;
};

/// The reason why the constraints of a model cannot be evaluated at a state with `entries` entries; empty if
/// they can.
inline base::sentence mistake_of_constraints(model& m, std::size_t entries) {
  m.get(mechanics::quantity::velocity_residual); // clears the mistake of the previous request
  if (!m.mistake().empty()) return base::sentence({m.mistake()});
  return compiled::check_size("state", "the model", static_cast<int>(entries),
                              m.mechanism().coordinates.size() + m.mechanism().speeds.size());
}

KANEXPR_ENGINE assembly assemble(model& m, std::span<double> x, std::span<const double> p,
                                 std::span<const double> r, double t, const assembly_options& options) {
  if (const base::sentence wrong = mistake_of_constraints(m, x.size())) return {.failure = wrong};
  constraints_at constraints(m, t, p, r);
  Eigen::Map<Eigen::VectorXd> given(x.data(), static_cast<Eigen::Index>(x.size()));
  Eigen::VectorXd placed = given;
  const assembly report = numeric::assemble(constraints, placed, options);
  given = placed;
  return report;
}

KANEXPR_ENGINE consistency check_consistency(model& m, std::span<const double> x, std::span<const double> p,
                                             std::span<const double> r, double t, double tolerance) {
  if (const base::sentence wrong = mistake_of_constraints(m, x.size())) return {.failure = wrong};
  constraints_at constraints(m, t, p, r);
  const Eigen::VectorXd state =
      Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  return numeric::check_consistency(constraints, state, tolerance);
}

} // namespace kanexpr::runtime
