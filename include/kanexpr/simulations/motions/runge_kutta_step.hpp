#pragma once

#include <kanexpr/simulations/motions/simulation_context.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

/// Vector operations as plain loops, which compile faster than Eigen's expressions.
namespace kanexpr::simulations {

/// Returns x + h k.
inline Eigen::VectorXd moved(const Eigen::VectorXd& x, double h, const Eigen::VectorXd& k) {
  Eigen::VectorXd to(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) to(i) = x(i) + h * k(i);
  return to;
}

/// Returns the largest magnitude of the entries of a, each divided by that of b.
inline double largest(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) most = (std::max)(most, std::abs(a(i) / b(i)));
  return most;
}

/// Takes a step with the midpoint rule and one with the classic Runge-Kutta method, from a state with its
/// rates; returns false if the rates cannot be evaluated.
inline bool runge_kutta_step(simulation_context& context, double t, const Eigen::VectorXd& x,
                             const Eigen::VectorXd& k1, double h, Eigen::VectorXd& midpoint,
                             Eigen::VectorXd& end) {
  Eigen::VectorXd k2, k3, k4;
  if (!context.find_rates(t + h / 2, moved(x, h / 2, k1), k2) ||
      !context.find_rates(t + h / 2, moved(x, h / 2, k2), k3) ||
      !context.find_rates(t + h, moved(x, h, k3), k4))
    return false;
  midpoint = moved(x, h, k2);
  end.resize(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) end(i) = x(i) + h / 6 * (k1(i) + 2 * k2(i) + 2 * k3(i) + k4(i));
  return true;
}

} // namespace kanexpr::simulations
