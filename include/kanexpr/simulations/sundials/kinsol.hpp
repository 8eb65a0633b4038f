#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulations/sundials/failure.hpp>
#include <kanexpr/simulations/sundials/least_squares.hpp>

#include <kinsol/kinsol.h>
#include <kinsol/kinsol_ls.h>

#include <Eigen/Core>
#include <algorithm>
#include <string>

namespace kanexpr::simulations {

/// f(z) = 0, with any number of equations and unknowns.
class nonlinear_equations {
public:
  virtual ~nonlinear_equations() = default;
  virtual int equations() const = 0;
  /// Returns how many of the unknowns, counted from the first, change only if the others cannot solve the
  /// equations.
  virtual int unknowns_kept_close() const = 0;
  /// Evaluates f at z; returns whether f has a value there.
  virtual bool residual(const Eigen::VectorXd& z, Eigen::VectorXd& f) = 0;
  virtual bool jacobian(const Eigen::VectorXd& z, Eigen::MatrixXd& slope) = 0;
  /// Returns by how much each unknown may change in one step.
  virtual Eigen::VectorXd limits(const Eigen::VectorXd& z) const = 0;
};

/// The outcome of a search. KINSOL's own report of success is not relied on: the caller checks the residuals.
struct search_end {
  int iterations = 0;
  std::string failure; ///< "the line search finds no better point"; empty if KINSOL succeeded
};

/// KINSOL: Newton's method with line search (Hindmarsh et al. 2005), here with the smallest least-squares
/// step.
class kinsol {
public:
  kinsol(nonlinear_equations& of, const magnitudes& sizes, double tolerance, int most_iterations)
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
    if (refused_) return {0, refused_.sentence};
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
    if (flag != KIN_SUCCESS && !refused_) refused_ = refusal(call);
    return flag == KIN_SUCCESS;
  }

  failure refusal(const char* call) const {
    return {std::string("SUNDIALS refused ") + call + (error_.message.empty() ? "" : ": " + error_.message)};
  }

  std::string reason_of(int flag) const {
    switch (flag) {
    case KIN_SUCCESS:
    case KIN_INITIAL_GUESS_OK: return {};
    case KIN_STEP_LT_STPTOL: return "the steps have become too small";
    case KIN_LINESEARCH_NONCONV:
    case KIN_LINESEARCH_BCFAIL: return "the line search finds no better point";
    case KIN_MAXITER_REACHED: return "after " + std::to_string(most_iterations_) + " iterations";
    case KIN_MXNEWT_5X_EXCEEDED: return "the steps do not get smaller";
    case KIN_SYSFUNC_FAIL:
    case KIN_FIRST_SYSFUNC_ERR:
    case KIN_REPTD_SYSFUNC_ERR: return "the equations have no value beyond this point";
    case KIN_LSETUP_FAIL:
    case KIN_LSOLVE_FAIL:
    case KIN_LINSOLV_NO_RECOVERY: return "the derivatives of the equations are not finite";
    default: return refusal("to continue").sentence; // out of memory, or a mistake in this library
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

  nonlinear_equations& of_;
  least_squares_step step_;
  Eigen::Index unknowns_, size_;
  int most_iterations_;
  Eigen::VectorXd at_, unknown_scale_, equation_scale_;
  last_error error_{};
  failure refused_{};
  ::sundials::Context context_{};
  vector_handle z_{}, unknown_scale_on_{}, equation_scale_on_{};
  matrix_handle matrix_{};
  linear_solver_handle solver_{};
  void* memory_ = nullptr;
};

} // namespace kanexpr::simulations
