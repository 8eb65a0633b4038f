#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

/// Vector operations of simulations as plain loops, which compile faster than Eigen's expressions.
namespace kanexpr::simulated {

/// Returns x + h k.
inline Eigen::VectorXd moved(const Eigen::VectorXd& x, double h, const Eigen::VectorXd& k) {
  Eigen::VectorXd to(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) to(i) = x(i) + h * k(i);
  return to;
}

/// Returns the end of a step of the classic Runge-Kutta method.
inline Eigen::VectorXd moved(const Eigen::VectorXd& x, double h, const Eigen::VectorXd& k1,
                             const Eigen::VectorXd& k2, const Eigen::VectorXd& k3,
                             const Eigen::VectorXd& k4) {
  Eigen::VectorXd to(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) to(i) = x(i) + h / 6 * (k1(i) + 2 * k2(i) + 2 * k3(i) + k4(i));
  return to;
}

/// Returns the largest magnitude of the entries of a, each divided by that of b.
inline double largest(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) most = (std::max)(most, std::abs(a(i) / b(i)));
  return most;
}

} // namespace kanexpr::simulated
