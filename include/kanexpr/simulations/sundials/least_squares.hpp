#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/complete_orthogonal.hpp>
#include <kanexpr/simulations/sundials/handles.hpp>

#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kanexpr::simulations {

/// The magnitudes of unknowns and equations, by which they are scaled.
struct magnitudes {
  Eigen::VectorXd unknowns, equations;
};

/// Newton's step for any number of equations: among the steps that minimize the linearized residual, the one
/// that changes the first `stiff` unknowns least, and then the others. The step is shortened if an unknown
/// would change by more than its limit.
class least_squares_step {
public:
  least_squares_step(magnitudes sizes, Eigen::Index stiff) : sizes_(std::move(sizes)), stiff_(stiff) {}

  void prepare(const Eigen::MatrixXd& slope, const Eigen::VectorXd& limits) {
    slope_ = slope;
    limits_ = limits;
    Eigen::MatrixXd a = slope;
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      a.col(j).array() *= sizes_.unknowns(j) / sizes_.equations.array();
    const double least = 1e-12 * a.norm();
    by_stiff_ = a.leftCols(stiff_);
    others_.emplace(a.rightCols(a.cols() - stiff_), least);
    const Eigen::MatrixXd& reached = others_->range();
    first_.emplace(by_stiff_ - reached.lazyProduct(reached.transpose().lazyProduct(by_stiff_).eval()), least);
  }

  /// Returns the step for the residual of the equations with its sign changed.
  Eigen::VectorXd operator()(const Eigen::VectorXd& wanted) const {
    const Eigen::VectorXd b = wanted.cwiseQuotient(sizes_.equations);
    Eigen::VectorXd step(slope_.cols());
    step.head(stiff_) = first_->solve(b);
    step.tail(step.size() - stiff_) = others_->solve(b - by_stiff_.lazyProduct(step.head(stiff_)));
    step.array() *= sizes_.unknowns.array();
    double longest = 1;
    for (Eigen::Index i = 0; i < step.size(); ++i)
      longest = (std::max)(longest, std::abs(step(i)) / limits_(i));
    return step / longest;
  }

  const Eigen::MatrixXd& slope() const { return slope_; }

private:
  magnitudes sizes_;
  Eigen::Index stiff_;
  Eigen::MatrixXd slope_{}, by_stiff_{};
  Eigen::VectorXd limits_{};
  std::optional<numeric::complete_orthogonal> first_{}, others_{};
};

/// Wraps the step as a linear solver of SUNDIALS. Its matrix is square; surplus rows and columns are zero.
/// The right-hand side returns the change of the equations along the step, which the line search uses.
inline linear_solver_handle linear_solver_by(least_squares_step& step, SUNContext context) {
  linear_solver_handle solver(SUNLinSolNewEmpty(context));
  if (solver == nullptr) return solver;
  solver->content = &step;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return SUNLS_SUCCESS; };
  solver->ops->solve = [](SUNLinearSolver s, SUNMatrix, N_Vector x, N_Vector b, realtype) {
    const auto& step_of = *static_cast<const least_squares_step*>(s->content);
    const Eigen::MatrixXd& slope = step_of.slope();
    const Eigen::Index size = N_VGetLength(b);
    Eigen::Map<Eigen::VectorXd> left(numbers_of(x), size), right(numbers_of(b), size);
    const Eigen::VectorXd found = step_of(right.head(slope.rows()));
    left.setZero();
    left.head(slope.cols()) = found;
    right.head(slope.rows()) = slope.lazyProduct(found);
    return numeric::all_finite(found) ? SUNLS_SUCCESS : SUNLS_PACKAGE_FAIL_UNREC;
  };
  solver->ops->free = [](SUNLinearSolver s) {
    SUNLinSolFreeEmpty(s);
    return SUNLS_SUCCESS;
  };
  return solver;
}

} // namespace kanexpr::simulations
