#pragma once

#include <kanexpr/simulate/configuration_manifold.hpp>

#include <limits>

namespace kanexpr::simulated {

/// The least correction that brings a state to the constraints and quaternions to norm 1, each entry measured
/// in units of 1/weight: first the coordinates by Newton's method, then the speeds, in which constraints are
/// linear (Eich 1993).
template <class System>
class constraint_projection {
public:
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int n = known.coordinates, o = known.speeds;
  static constexpr int l = configuration_manifold<System>::equations, m = known.constraints;
  static constexpr bool is_needed = l + m != 0;
  using vector = Eigen::Matrix<double, n + o, 1>;

  /// False where the constraints are dependent, or cannot be reached from there.
  template <class P, class R>
  bool operator()(double t, const vector& y, const P& p, const R& r, const vector& weights) {
    units_ = weights.cwiseAbs2().cwiseInverse();
    correction_.setZero();
    return project_coordinates(t, y, p, r, weights) && project_speeds(t, y, p, r);
  }

  const vector& correction() const { return correction_; }

  /// Takes what points away from the constraints off an error estimate.
  void project_error(Eigen::Map<vector>& error) const {
    if constexpr (l != 0)
      error.template head<n>() += along(by_q_, q_units(), -by_q_ * error.template head<n>());
    if constexpr (m != 0)
      error.template tail<o>() += along(by_u_, u_units(), -by_u_ * error.template tail<o>());
  }

private:
  using constraints = compiled::constraints_at<System, parameter_values<System>, input_values<System>>;

  auto q_units() const { return units_.template head<n>(); }
  auto u_units() const { return units_.template tail<o>(); }

  /// D Jᵀ (J D Jᵀ)⁻¹ b, the least vector that J takes to b.
  template <class Jacobian, class Units, class Right>
  static auto along(const Jacobian& j, const Units& units, const Right& b) {
    constexpr int rows = Jacobian::RowsAtCompileTime;
    Eigen::Matrix<double, rows, 1> x = b;
    const Eigen::Matrix<double, Jacobian::ColsAtCompileTime, rows> spread =
        units.asDiagonal() * j.transpose();
    const Eigen::Matrix<double, rows, rows> square = j * spread;
    const numeric::factorized<Eigen::Matrix<double, rows, 1>> factors(square);
    factors.solve(x);
    return Eigen::Matrix<double, Jacobian::ColsAtCompileTime, 1>(spread * x);
  }

  template <class P, class R>
  bool project_coordinates(double t, const vector& y, const P& p, const R& r, const vector& weights) {
    if constexpr (l != 0) {
      double last = std::numeric_limits<double>::infinity();
      for (int steps = 0; steps < most_steps; ++steps) {
        const vector at = y + correction_;
        const auto kept = configuration_manifold<System>::template at<double>(t, at, p, r);
        by_q_ = kept.by_coordinates;
        const auto step = along(by_q_, q_units(), -kept.residual);
        if (!step.allFinite()) return false;
        correction_.template head<n>() += step;
        const double size = step.cwiseProduct(weights.template head<n>()).cwiseAbs().maxCoeff();
        if (size <= close_enough || (size <= 1 && size > last / 4)) return true; // or rounding is met
        last = size;
      }
      return false;
    }
    return true;
  }

  template <class P, class R>
  bool project_speeds(double t, const vector& y, const P& p, const R& r) {
    if constexpr (m != 0) {
      const auto [residual, jacobian] = constraints::velocities()(t, vector(y + correction_), p, r);
      by_u_ = jacobian;
      correction_.template tail<o>() = along(by_u_, u_units(), -residual);
    }
    return correction_.allFinite();
  }

  /// A step this small beside the tolerances leaves its square, which is nothing.
  static constexpr double close_enough = 1e-2;
  static constexpr int most_steps = 10;

  vector units_{}, correction_ = vector::Zero();
  Eigen::Matrix<double, l, n> by_q_{};
  Eigen::Matrix<double, m, o> by_u_{};
};

} // namespace kanexpr::simulated
