#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/mechanics/linearize/linearization.hpp>
#include <kanexpr/numeric/equilibrated.hpp>
#include <kanexpr/numeric/factorized.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <Eigen/Core>
#include <algorithm>

namespace kanexpr::runtime {

/// Computes M⁻¹ [A B] of a linearization whose entries are all numbers, by elimination with row exchanges.
/// The result does not depend on the units of equations and unknowns.
class solve_numbers {
public:
  static bool are_numbers(const symbolic::matrix& m) {
    return std::all_of(m.entries.begin(), m.entries.end(), [](const auto& e) { return e.is_constant(); });
  }

  solve_numbers(symbolic::graph& g, const mechanics::implicit_linearization& given)
      : g_(g), mass_(numbers_of(given.mass)), scale_(mass_), factors_(scale_.applied_to(mass_)),
        rates_(g, given.mass.rows, given.state.columns + given.input.columns) {
    if (!*this) return;
    int done = 0;
    for (const symbolic::matrix* right : {&given.state, &given.input})
      for (int j = 0; j < right->columns; ++j) solve(numbers_of(*right).col(j), done++);
  }

  /// Whether M is regular.
  explicit operator bool() const { return factors_.singularity_measure() > base::vanishing_measure; }

  /// δ[q̇; u̇; λ], with a column for each state, followed by one for each input.
  const symbolic::matrix& rates() const { return rates_; }

private:
  Eigen::MatrixXd numbers_of(const symbolic::matrix& m) const {
    Eigen::MatrixXd numbers(m.rows, m.columns);
    for (int i = 0; i < m.rows; ++i)
      for (int j = 0; j < m.columns; ++j) numbers(i, j) = g_.number_at(m(i, j).node()).value();
    return numbers;
  }

  void solve(const Eigen::VectorXd& right, int into) {
    Eigen::VectorXd x = scale_.rows.cwiseProduct(right);
    factors_.solve(x);
    for (int i = 0; i < rates_.rows; ++i)
      rates_(i, into) = symbolic::constant(g_, symbolic::real(scale_.columns(i) * x(i)));
  }

  symbolic::graph& g_;
  Eigen::MatrixXd mass_;
  numeric::equilibration<Eigen::VectorXd> scale_;
  numeric::factorized<Eigen::VectorXd> factors_;
  symbolic::matrix rates_;
};

} // namespace kanexpr::runtime
