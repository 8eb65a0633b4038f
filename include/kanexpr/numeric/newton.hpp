#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/equilibrated.hpp>
#include <kanexpr/numeric/factorized.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <limits>

/// Numerical methods for plain functions of vectors.
namespace kanexpr::numeric {

struct newton_options {
  int most_steps = 50;
  /// The largest permitted relative change in the Jacobian over the last step.
  double tolerance = 1e-10;
};

struct newton_report {
  bool converged = false;
  bool singular = false; ///< the final Jacobian was singular
  int steps = 0;
  double residual = 0; ///< the largest final magnitude
};

/// Solves f(x) = 0 by Newton's method and halves each step until the residual decreases. If the Jacobian is
/// singular, the step is a damped least-squares step (Levenberg). After convergence, the iteration continues
/// as long as the residual decreases, so the result is as accurate as rounding permits. The units of
/// equations and unknowns do not matter. No memory is allocated for fixed-size vectors.
template <class Vector, class Function, class Jacobian>
newton_report newton(Vector& x, const Function& function, const Jacobian& jacobian,
                     const newton_options& options = {}) {
  using number = typename Vector::Scalar;
  using Matrix = Eigen::Matrix<number, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>;
  newton_report report;
  Vector f = function(x);
  // smaller changes in the Jacobian are rounding errors
  const double least_change = (std::max)(options.tolerance, 1024.0 * std::numeric_limits<number>::epsilon());
  report.residual = largest(f);
  if (!all_finite(f)) return report;
  if (x.size() == 0 || base::equal(report.residual, 0.0)) report.converged = true;
  if (report.converged) return report;

  bool continues = true;
  while (continues && report.steps < options.most_steps) {
    const Matrix slope = jacobian(x);
    if (!all_finite(slope)) break;
    const equilibration<Vector> scale(slope);
    const Matrix scaled = scale.applied_to(slope);
    factorized<Vector> factors(scaled);
    report.singular = factors.is_singular();
    Vector step = -scale.rows.cwiseProduct(f);
    if (report.singular) {
      Matrix damped = scaled.transpose().lazyProduct(scaled);
      damped.diagonal().array() += number(1e-6) * damped.trace();
      step = Vector(scaled.transpose().lazyProduct(step));
      factors = factorized<Vector>(damped);
    }
    factors.solve(step);
    step = step.cwiseProduct(scale.columns);
    if (!all_finite(step)) break;

    const Vector before = x;
    const number norm_before = scale.rows.cwiseProduct(f).norm();
    number part = 1;
    bool decreased = false;
    for (int halvings = 0; halvings < 30 && !decreased; ++halvings, part /= 2) {
      const Vector tried = before + part * step;
      const Vector left = function(tried);
      if (!all_finite(left) || !(scale.rows.cwiseProduct(left).norm() < norm_before)) continue;
      x = tried;
      f = left;
      decreased = true;
    }
    ++report.steps;
    report.residual = largest(f);
    continues = decreased && !base::equal(report.residual, 0.0);
    if (!report.singular && (!continues || report.steps == options.most_steps)) {
      const Matrix after = scale.applied_to(Matrix(jacobian(before + step)));
      report.converged = (after - scaled).cwiseAbs().maxCoeff() <= static_cast<number>(least_change);
    }
  }
  if (base::equal(report.residual, 0.0)) report.converged = true;
  return report;
}

} // namespace kanexpr::numeric
