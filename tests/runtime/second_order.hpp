#pragma once

#include "runtime/agreement.hpp"

#include <complex>
#include <random>

/// Compares second derivatives of weighted rates with complex steps of the first derivatives, at random
/// states that violate the constraints.
namespace to_second_order {

using complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using kanexpr::mechanics::quantity;

inline constexpr double step = 1e-30;

inline VectorXd random_numbers(std::mt19937_64& source, Index count, double reach) {
  std::uniform_real_distribution<double> unit(-reach, reach);
  return VectorXd::NullaryExpr(count, [&] { return unit(source); });
}

struct derivatives {
  kanexpr::model m;
  kanexpr::runtime::interpreted<double> hessian = m.function(m.get(quantity::weighted_hessian));
  kanexpr::runtime::interpreted<double> product = m.function(m.get(quantity::weighted_hessian_product));
  kanexpr::runtime::interpreted<double> gradient = m.function(m.get(quantity::weighted_gradient));
  kanexpr::runtime::interpreted<double> along = m.function(m.get(quantity::directional_derivative));
  kanexpr::runtime::interpreted<complex> by_state = m.function<complex>(m.get(quantity::state_jacobian));
  kanexpr::runtime::interpreted<complex> by_inputs = m.function<complex>(m.get(quantity::input_jacobian));

  Index coordinates = m.mechanism().coordinates.size(), speeds = m.mechanism().speeds.size(),
        inputs = m.mechanism().inputs.size(), parameters = m.mechanism().parameters.size();
  Index states = coordinates + speeds, size = states + inputs;
  int quaternion = -1; ///< index of the first one among the coordinates

  explicit derivatives(kanexpr::model of) : m(std::move(of)) {}

  /// ∂ẋ/∂z.
  Eigen::MatrixXcd jacobian(double t, const VectorXcd& z, const VectorXd& p) {
    const VectorXcd x = z.head(states), r = z.tail(inputs);
    Eigen::MatrixXcd all(states, size);
    all.leftCols(states) = by_state(t, x, p, r);
    if (inputs > 0) all.rightCols(inputs) = by_inputs(t, x, p, r);
    return all;
  }
};

// The second derivative of λᵀẋ at s = 0 along a path z(s) that preserves the norms of quaternions, by a
// complex step.
inline double bend(derivatives& of, double t, const VectorXd& z, const VectorXd& p, const VectorXd& w,
                   const VectorXd& v) {
  const complex s(0, step);
  VectorXcd there = z + s * v, velocity = v;
  if (of.quaternion >= 0) { // e cos ωs + e' sin ωs / ω, to first order in s
    const auto e = z.segment(of.quaternion, 4);
    velocity.segment(of.quaternion, 4) -= s * v.segment(of.quaternion, 4).squaredNorm() * e;
  }
  return (w.transpose() * of.jacobian(t, there, p) * velocity)(0).imag() / step;
}

inline void expect_second_order(derivatives of, double reach = 1) {
  ASSERT_EQ(of.m.mistake(), "");
  std::mt19937_64 source(7);
  int compared = 0;
  for (int tried = 0; compared < 20 && tried < 100; ++tried) {
    const double t = random_numbers(source, 1, 1)(0);
    VectorXd z = random_numbers(source, of.size, 2), v = random_numbers(source, of.size, 1);
    z.head(of.coordinates) *= reach / 2;
    const VectorXd w = random_numbers(source, of.states, 1),
                   p = VectorXd::Constant(of.parameters, 1) + random_numbers(source, of.parameters, 0.3);
    if (of.quaternion >= 0) {
      auto e = z.segment(of.quaternion, 4), change = v.segment(of.quaternion, 4);
      e.normalize();
      change -= (change.dot(e) * e).eval();
    }
    const VectorXd x = z.head(of.states), r = z.tail(of.inputs);
    const MatrixXd jacobian = of.jacobian(t, z, p).real();
    if (!jacobian.allFinite() || jacobian.cwiseAbs().maxCoeff() > 1e5) continue; // nearly singular
    const MatrixXd hessian = of.hessian(t, x, p, r, w);
    ASSERT_TRUE(of.hessian.status()) << of.hessian.status().cause();
    EXPECT_EQ(hessian, hessian.transpose());
    const VectorXd gradient = of.gradient(t, x, p, r, w), along = of.along(t, x, p, r, v),
                   product = of.product(t, x, p, r, w, v);
    EXPECT_LE((gradient - jacobian.transpose() * w).norm(), 1e-12 * jacobian.norm());
    EXPECT_LE((along - jacobian * v).norm(), 1e-12 * jacobian.norm() * v.norm());
    EXPECT_LE((product - hessian * v).norm(), 1e-12 * hessian.norm() * v.norm());
    const double scale = hessian.norm() * v.squaredNorm();
    if (of.quaternion < 0) {
      MatrixXd by_steps(of.size, of.size);
      for (Index j = 0; j < of.size; ++j) {
        VectorXcd there = z;
        there(j) += complex(0, step);
        by_steps.col(j) = (of.jacobian(t, there, p).transpose() * w).imag() / step;
      }
      EXPECT_LE((hessian - by_steps).norm(), 1e-11 * by_steps.norm());
    } else {
      VectorXd e = VectorXd::Zero(of.size);
      e.segment(of.quaternion, 4) = z.segment(of.quaternion, 4);
      const double found = v.dot(hessian * v) - v.segment(of.quaternion, 4).squaredNorm() * gradient.dot(e);
      EXPECT_NEAR(found, bend(of, t, z, p, w, v), 1e-11 * scale);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

} // namespace to_second_order
