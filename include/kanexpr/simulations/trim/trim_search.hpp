#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/trim/trim_equations.hpp>

#include <Eigen/Core>
#include <limits>
#include <string>
#include <utility>

namespace kanexpr::simulations {

/// KINSOL's search, followed by Newton steps as long as they reduce the residual.
class search {
public:
  search(const conditions& of, trim_equations& equations, double tolerance, int most_iterations)
      : of_(of), equations_(equations), tolerance_(tolerance), most_iterations_(most_iterations),
        z_(equations.start()) {}

  search_result find() {
    if (const std::string mistake = check_start(); !mistake.empty()) {
      found_.failure = mistake;
    } else {
      if (z_.size() != 0) run();
      check_solution();
    }
    found_.values = equations_.values(z_);
    for (Eigen::Index i = 0; i < left_.size(); ++i) found_.residuals.push_back({name_of(i), left_(i)});
    return std::move(found_);
  }

private:
  std::string check_start() {
    if (equations_.residual(z_, left_))
      return equations_.jacobian(z_, slope_) ? ""
                                             : "the derivatives of the equations are not finite at the guess";
    if (!equations_.unsolved().empty()) return "at the guess: " + std::string(equations_.unsolved());
    Eigen::Index i = 0;
    while (numeric::is_finite(left_(i))) ++i;
    return name_of(i) + " is not finite at the guess";
  }

  void run() {
    kinsol newton(equations_, equations_.magnitudes_at(z_), tolerance_, most_iterations_);
    const search_end end = newton.solve(z_);
    found_.iterations = end.iterations;
    failure_ = end.failure;
    if (!equations_.residual(z_, left_) || !equations_.jacobian(z_, slope_)) return;
    const magnitudes sizes = equations_.magnitudes_at(z_);
    while (found_.iterations < most_iterations_ && refine(sizes)) ++found_.iterations;
  }

  /// Takes a Newton step; returns false if it does not reduce the residual or the residual is already
  /// negligible.
  bool refine(const magnitudes& sizes) {
    const auto size = [&](const Eigen::VectorXd& f) { return f.cwiseQuotient(sizes.equations).norm(); };
    if (size(left_) < 1e-3 * std::numeric_limits<double>::epsilon()) return false;
    least_squares_step step(sizes, equations_.unknowns_kept_close());
    step.prepare(slope_, equations_.limits(z_));
    const Eigen::VectorXd tried = z_ + step(-left_);
    Eigen::VectorXd left;
    if (!equations_.residual(tried, left) || !(size(left) < size(left_))) return false;
    z_ = tried;
    left_ = left;
    return equations_.jacobian(z_, slope_);
  }

  void check_solution() {
    if (!equations_.residual(z_, left_) || !equations_.jacobian(z_, slope_)) {
      found_.failure = "no operating point: where the search ended, " +
                       (equations_.unsolved().empty() ? "the equations are not finite"
                                                      : std::string(equations_.unsolved()));
      return;
    }
    const magnitudes sizes = equations_.magnitudes_at(z_);
    found_.freedom = equations_.unknowns() - rank(slope_, sizes);
    if (left_.size() == 0) return;
    Eigen::Index worst = 0;
    if (!(left_.cwiseQuotient(sizes.equations).cwiseAbs().maxCoeff(&worst) <= tolerance_))
      found_.failure = "no operating point: " + left_at(worst) + " where the search ended" +
                       (failure_.empty() ? "" : " (" + failure_ + ")");
  }

  /// Returns the rank with columns scaled to equal length, so that unknowns with a small effect are counted.
  static int rank(Eigen::MatrixXd slope, const magnitudes& sizes) {
    for (Eigen::Index j = 0; j < slope.cols(); ++j) {
      slope.col(j).array() *= sizes.unknowns(j) / sizes.equations.array();
      const double length = slope.col(j).norm();
      slope.col(j) *= length < 1e-12 ? 0 : 1 / length;
    }
    return static_cast<int>(numeric::orthonormal_columns(slope, 1e-9).cols());
  }

  const condition& equation(Eigen::Index i) const { return of_.equations()[static_cast<std::size_t>(i)]; }
  std::string name_of(Eigen::Index i) const { return of_.name_of(equation(i)); }
  /// "the rate of speed u2 is 0.31", "… instead of 0.3", "velocity constraint 1 has a residual of 0.31".
  std::string left_at(Eigen::Index i) const {
    const condition& c = equation(i);
    if (c.place < of_.residuals()) return name_of(i) + " has a residual of " + base::digits(left_(i), 3);
    return name_of(i) + " is " + base::digits(left_(i) + c.wanted, 3) +
           (base::equal(c.wanted, 0.0) ? "" : " instead of " + base::digits(c.wanted, 3));
  }

  const conditions& of_;
  trim_equations& equations_;
  double tolerance_;
  int most_iterations_;
  Eigen::VectorXd z_, left_{}; ///< the unknowns; the residuals of the equations
  Eigen::MatrixXd slope_{};
  std::string failure_{};
  search_result found_{};
};

KANEXPR_SIMULATIONS search_result find(const system_functions& system, const requirements& asked,
                                       const Eigen::VectorXd& guess) {
  const conditions of(system.known, system.record, system.name, asked);
  if (of.mistake()) return {.values = guess, .failure = std::string(of.mistake().view())};
  trim_equations equations(of, system, asked.t, guess);
  return search(of, equations, asked.tolerance, asked.most_iterations).find();
}

} // namespace kanexpr::simulations
