#pragma once

#include <kanexpr/simulations/sundials/adaptive.hpp>

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <cvode/cvode_proj.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <utility>
#include <vector>

namespace kanexpr::simulations {

struct cvode_calls {
  KANEXPR_SUNDIALS_CALLS(CVode, CV);

  static constexpr bool is_evaluation(int flag) {
    return flag <= CV_RHSFUNC_FAIL && flag >= CV_UNREC_RHSFUNC_ERR;
  }
  static constexpr bool is_projection(int flag) {
    return flag == CV_PROJFUNC_FAIL || flag == CV_REPTD_PROJFUNC_ERR;
  }
};

/// The multistep methods of CVODE: Adams' with functional iteration, and backward differentiation with
/// Newton's method and projection onto the constraints (Hindmarsh et al. 2005).
class cvode final : public adaptive<cvode_calls, explicit_problem> {
public:
  enum class formulas : int { adams = CV_ADAMS, backward_differences = CV_BDF };

  cvode(formulas of, explicit_problem& problem, double from, std::vector<double> start,
        stepper_options options)
      : adaptive(problem, from, std::move(start), std::move(options)), formulas_(of) {
    memory_ = CVodeCreate(static_cast<int>(formulas_), context_);
    if (has_memory() && accepted(CVodeInit(memory_, rates, t_, at_.get()), "the first state") &&
        set_common() && set_solver() && !reports_projected_states() && problem_.has_manifold())
      accepted(CVodeSetProjFn(memory_, project), "the projection onto the constraints");
  }

  /// CVODE cannot project Adams' formulas itself. The reported state is projected instead, and the drift of
  /// the formulas is gradually corrected.
  bool reports_projected_states() const override {
    return formulas_ == formulas::adams && problem_.has_manifold();
  }

  int degree() const override { return number<int>(CVodeGetLastOrder); }

private:
  int solve(double target) override { return CVode(memory_, target, at_.get(), &t_, CV_ONE_STEP); }
  int reinitialize() override { return CVodeReInit(memory_, t_, at_.get()); }

  bool set_solver() {
    if (formulas_ == formulas::adams) {
      iteration_.reset(SUNNonlinSol_FixedPoint(at_.get(), 0, context_));
      return accepted(CVodeSetNonlinearSolver(memory_, iteration_.get()), "the functional iteration");
    }
    return set_newton(jacobian);
  }

  static int project(double t, N_Vector y, N_Vector correction, double, N_Vector error, void* of) {
    cvode& c = *static_cast<cvode*>(static_cast<adaptive*>(of));
    return static_cast<int>(c.problem_.project(t, numbers_of(y), c.weights(), numbers_of(correction),
                                               error == nullptr ? nullptr : numbers_of(error)));
  }

  formulas formulas_;
  nonlinear_solver_handle iteration_{};
};

} // namespace kanexpr::simulations
