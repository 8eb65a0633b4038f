#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/complete_orthogonal.hpp>
#include <kanexpr/simulations/sundials/handles.hpp>

#include <kinsol/kinsol.h>
#include <kinsol/kinsol_ls.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
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

  /// Returns the step for the negative residual of the equations.
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

/// Wraps the step as a SUNDIALS linear solver. Its matrix is square; surplus rows and columns are zero. On
/// return, the right-hand side contains the change of the residual along the step, which the line search
/// uses.
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

/// The outcome of a search. The caller checks the residuals and does not rely on KINSOL's report of success.
struct search_end {
  int iterations = 0;
  std::string failure; ///< "the line search found no better point"; empty if KINSOL succeeded
};

/// KINSOL: Newton's method with line search (Hindmarsh et al. 2005), here with the smallest least-squares
/// step. `Equations` represents f(z) = 0, with any number of equations and unknowns.
template <class Equations>
class kinsol {
public:
  kinsol(Equations& of, const magnitudes& sizes, double tolerance, int most_iterations)
      : of_(of), step_(sizes, of.unknowns_kept_close()), unknowns_(sizes.unknowns.size()),
        size_((std::max)(unknowns_, sizes.equations.size())), most_iterations_(most_iterations),
        at_(Eigen::VectorXd::Zero(size_)), unknown_scale_(Eigen::VectorXd::Ones(size_)),
        equation_scale_(Eigen::VectorXd::Ones(size_)) {
    unknown_scale_.head(unknowns_) = sizes.unknowns.cwiseInverse();
    equation_scale_.head(sizes.equations.size()) = sizes.equations.cwiseInverse();
    start(tolerance);
  }
  kinsol(const kinsol&) = delete;
  kinsol& operator=(const kinsol&) = delete;
  ~kinsol() { KINFree(&memory_); }

  /// Searches from z, which is set to the point where the search ends.
  search_end solve(Eigen::VectorXd& z) {
    if (!refused_.empty()) return {0, refused_};
    at_.head(unknowns_) = z;
    const int flag =
        KINSol(memory_, z_.get(), KIN_LINESEARCH, unknown_scale_on_.get(), equation_scale_on_.get());
    long iterations = 0;
    KINGetNumNonlinSolvIters(memory_, &iterations);
    if (numeric::all_finite(at_)) z = at_.head(unknowns_);
    return {static_cast<int>(iterations), reason_of(flag)};
  }

private:
  void start(double tolerance) {
    z_ = vector_on(at_.data(), size_, context_);
    unknown_scale_on_ = vector_on(unknown_scale_.data(), size_, context_);
    equation_scale_on_ = vector_on(equation_scale_.data(), size_, context_);
    matrix_.reset(SUNDenseMatrix(size_, size_, context_));
    solver_ = linear_solver_by(step_, context_);
    memory_ = KINCreate(context_);
    const bool has_memory = memory_ != nullptr && z_ != nullptr && unknown_scale_on_ != nullptr &&
                            equation_scale_on_ != nullptr && matrix_ != nullptr && solver_ != nullptr;
    if (!has_memory) {
      refused_ = refusal("memory for KINSOL");
      return;
    }
    constexpr double any = 1e100;
    static_cast<void>(
        accepted(KINSetErrHandlerFn(memory_, last_error::handle, &error_), "an error handler") &&
        accepted(KINSetUserData(memory_, this), "the user data") &&
        accepted(KINInit(memory_, residual, z_.get()), "the equations") &&
        accepted(KINSetLinearSolver(memory_, solver_.get(), matrix_.get()), "the linear solver") &&
        accepted(KINSetJacFn(memory_, jacobian), "the Jacobian") &&
        accepted(KINSetFuncNormTol(memory_, tolerance), "the tolerance") &&
        accepted(KINSetNumMaxIters(memory_, most_iterations_), "the number of iterations") &&
        accepted(KINSetMaxSetupCalls(memory_, 1), "a Jacobian in each iteration") &&
        accepted(KINSetMaxNewtonStep(memory_, any), "steps of any length"));
  }

  bool accepted(int flag, const char* call) {
    if (flag != KIN_SUCCESS && refused_.empty()) refused_ = refusal(call);
    return flag == KIN_SUCCESS;
  }

  std::string refusal(const char* call) const {
    return error_.after(std::string("SUNDIALS refused ") + call);
  }

  std::string reason_of(int flag) const {
    switch (flag) {
    case KIN_SUCCESS:
    case KIN_INITIAL_GUESS_OK: return {};
    case KIN_STEP_LT_STPTOL: return "the steps have become too small";
    case KIN_LINESEARCH_NONCONV:
    case KIN_LINESEARCH_BCFAIL: return "the line search found no better point";
    case KIN_MAXITER_REACHED: return "after " + std::to_string(most_iterations_) + " iterations";
    case KIN_MXNEWT_5X_EXCEEDED: return "the steps do not get smaller";
    case KIN_SYSFUNC_FAIL:
    case KIN_FIRST_SYSFUNC_ERR:
    case KIN_REPTD_SYSFUNC_ERR: return "the equations cannot be evaluated beyond this point";
    case KIN_LSETUP_FAIL:
    case KIN_LSOLVE_FAIL:
    case KIN_LINSOLV_NO_RECOVERY: return "the derivatives of the equations are not finite";
    default: return refusal("to continue"); // out of memory, or a mistake in this library
    }
  }

  // KINSOL's callbacks; a positive return value makes it try a shorter step
  static int residual(N_Vector z, N_Vector f, void* of) {
    kinsol& self = *static_cast<kinsol*>(of);
    Eigen::VectorXd left;
    if (!self.of_.residual(self.unknowns_at(z), left)) return 1;
    Eigen::Map<Eigen::VectorXd> all(numbers_of(f), self.size_);
    all.setZero();
    all.head(left.size()) = left;
    return 0;
  }
  static int jacobian(N_Vector z, N_Vector, SUNMatrix, void* of, N_Vector, N_Vector) {
    kinsol& self = *static_cast<kinsol*>(of);
    Eigen::MatrixXd slope;
    const Eigen::VectorXd at = self.unknowns_at(z);
    if (!self.of_.jacobian(at, slope)) return 1;
    self.step_.prepare(slope, self.of_.limits(at));
    return 0;
  }
  Eigen::VectorXd unknowns_at(N_Vector z) const {
    return Eigen::Map<const Eigen::VectorXd>(numbers_of(z), unknowns_);
  }

  Equations& of_;
  least_squares_step step_;
  Eigen::Index unknowns_, size_;
  int most_iterations_;
  Eigen::VectorXd at_, unknown_scale_, equation_scale_;
  last_error error_{};
  std::string refused_{};
  ::sundials::Context context_{};
  vector_handle z_{}, unknown_scale_on_{}, equation_scale_on_{};
  matrix_handle matrix_{};
  linear_solver_handle solver_{};
  void* memory_ = nullptr;
};

} // namespace kanexpr::simulations
