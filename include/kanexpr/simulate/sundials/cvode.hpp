#pragma once

#include <kanexpr/simulate/sundials/adaptive.hpp>

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <cvode/cvode_proj.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace kanexpr::solvers {

struct cvode_calls {
  static constexpr auto free = CVodeFree;
  static constexpr auto set_error_handler = CVodeSetErrHandlerFn;
  static constexpr auto set_user_data = CVodeSetUserData;
  static constexpr auto set_weights = CVodeWFtolerances;
  static constexpr auto set_first_step = CVodeSetInitStep;
  static constexpr auto set_least_step = CVodeSetMinStep;
  static constexpr auto set_greatest_step = CVodeSetMaxStep;
  static constexpr auto set_end = CVodeSetStopTime;
  static constexpr auto watch = CVodeRootInit;
  static constexpr auto set_directions = CVodeSetRootDirection;
  static constexpr auto no_warnings = CVodeSetNoInactiveRootWarn;
  static constexpr auto root_info = CVodeGetRootInfo;
  static constexpr auto derivative = CVodeGetDky;
  static constexpr auto last_step = CVodeGetLastStep;
  static constexpr auto next_step = CVodeGetCurrentStep;
  static constexpr auto current_time = CVodeGetCurrentTime;
  static constexpr auto steps = CVodeGetNumSteps;
  static constexpr auto error_test_failures = CVodeGetNumErrTestFails;
  static constexpr auto solver_failures = CVodeGetNumStepSolveFails;
  static constexpr auto jacobians = CVodeGetNumJacEvals;
  static constexpr auto set_linear_solver = CVodeSetLinearSolver;
  static constexpr auto set_jacobian = CVodeSetJacFn;
  static constexpr auto error_weights = CVodeGetErrWeights;

  static constexpr int event_failed = CV_RTFUNC_FAIL;
  static constexpr bool is_evaluation(int flag) {
    return flag <= CV_RHSFUNC_FAIL && flag >= CV_UNREC_RHSFUNC_ERR;
  }
  static constexpr bool is_projection(int flag) {
    return flag == CV_PROJFUNC_FAIL || flag == CV_REPTD_PROJFUNC_ERR;
  }
};

/// The multistep methods of CVODE: Adams' with functional iteration, and backward differentiation with
/// Newton's method and projection onto the constraints (Hindmarsh et al. 2005).
class cvode final : public adaptive<cvode_calls> {
public:
  enum class formulas : int { adams = CV_ADAMS, backward_differences = CV_BDF };

  cvode(formulas of, explicit_problem& problem, double from, std::vector<double> start,
        stepper_options options)
      : adaptive(problem, from, std::move(start), std::move(options)), formulas_(of), problem_(problem) {
    memory_ = CVodeCreate(static_cast<int>(formulas_), context_);
    if (has_memory() && done(CVodeInit(memory_, rates, t_, at_.get()), "the first state") && set_common() &&
        set_solver() && !projects_itself() && problem_.has_constraints())
      done(CVodeSetProjFn(memory_, project), "the projection onto the constraints");
  }

  bool shows_projected() const override { return projects_itself(); }

  arrival advance(double target) override {
    const arrival at = adaptive::advance(target);
    return at == arrival::failed || !projects_itself() || return_to_constraints() ? at : arrival::failed;
  }

  int degree() const override {
    int order = 0;
    CVodeGetLastOrder(memory_, &order);
    return order;
  }

  bool restart() override {
    way_back_.clear();
    keep_counts();
    return done(CVodeReInit(memory_, t_, at_.get()), "a new state") && set_end();
  }

private:
  int solve(double target) override { return CVode(memory_, target, at_.get(), &t_, CV_ONE_STEP); }

  bool set_solver() {
    if (formulas_ == formulas::adams) {
      iteration_.reset(SUNNonlinSol_FixedPoint(at_.get(), 0, context_));
      return done(CVodeSetNonlinearSolver(memory_, iteration_.get()), "the functional iteration");
    }
    return set_newton(problem_, jacobian);
  }

  /// CVODE cannot project Adams' formulas itself. The reported state is projected instead, and the drift of
  /// the formulas is led back.
  bool projects_itself() const { return formulas_ == formulas::adams && problem_.has_constraints(); }

  bool return_to_constraints() {
    return correct([&](double t, const double* y, const double* weights, double* correction) {
      return problem_.project(t, y, weights, correction, nullptr);
    });
  }

  static cvode& self(void* of) { return static_cast<cvode&>(*static_cast<adaptive*>(of)); }
  static int rates(double t, N_Vector y, N_Vector ydot, void* of) {
    cvode& c = self(of);
    const answer found = c.problem_.rates(t, numbers_of(y), numbers_of(ydot));
    for (std::size_t i = 0; i < c.way_back_.size(); ++i) numbers_of(ydot)[i] += c.way_back_[i];
    return static_cast<int>(found);
  }
  static int jacobian(double t, N_Vector y, N_Vector, SUNMatrix j, void* of, N_Vector, N_Vector, N_Vector) {
    return static_cast<int>(self(of).problem_.jacobian(t, numbers_of(y), SUNDenseMatrix_Data(j)));
  }
  static int project(double t, N_Vector y, N_Vector correction, double, N_Vector error, void* of) {
    return static_cast<int>(self(of).problem_.project(t, numbers_of(y), self(of).weights(),
                                                      numbers_of(correction),
                                                      error == nullptr ? nullptr : numbers_of(error)));
  }

  formulas formulas_;
  explicit_problem& problem_;
  nonlinear_solver_handle iteration_{};
};

} // namespace kanexpr::solvers
