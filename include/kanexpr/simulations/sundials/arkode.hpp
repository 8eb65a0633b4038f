#pragma once

#include <kanexpr/simulations/sundials/adaptive.hpp>

#include <arkode/arkode_arkstep.h>

#include <utility>
#include <vector>

namespace kanexpr::simulations {

struct arkode_calls {
  KANEXPR_SUNDIALS_CALLS(ARKStep, ARK);

  static constexpr bool is_evaluation(int flag) {
    return flag <= ARK_RHSFUNC_FAIL && flag >= ARK_UNREC_RHSFUNC_ERR;
  }
  static constexpr bool is_projection(int flag) { return flag == ARK_POSTPROCESS_STEP_FAIL; }
};

/// The Runge-Kutta methods of ARKODE (Reynolds et al. 2023): the explicit one of Dormand & Prince and the
/// implicit, L-stable one of Kvaerno, both of order 5. Each step starts afresh, so events and projections
/// cost nothing extra.
class arkode final : public adaptive<arkode_calls, explicit_problem> {
public:
  enum class formulas { explicit_stages, implicit_stages };

  arkode(formulas of, explicit_problem& problem, double from, std::vector<double> start,
         stepper_options options)
      : adaptive(problem, from, std::move(start), std::move(options)) {
    const bool implicit = of == formulas::implicit_stages;
    (implicit ? implicit_ : explicit_) = rates;
    memory_ = ARKStepCreate(explicit_, implicit_, t_, at_.get(), context_);
    if (!has_memory() || !set_common()) return;
    const ARKODE_DIRKTableID stages = implicit ? ARKODE_KVAERNO_7_4_5 : ARKODE_DIRK_NONE;
    const ARKODE_ERKTableID explicit_stages = implicit ? ARKODE_ERK_NONE : ARKODE_DORMAND_PRINCE_7_4_5;
    if (accepted(ARKStepSetTableNum(memory_, stages, explicit_stages), "the table of coefficients") &&
        accepted(ARKStepSetInterpolantDegree(memory_, ARK_INTERP_MAX_DEGREE),
                 "the degree of interpolation") &&
        (!implicit || set_newton(jacobian)) && problem_.has_manifold())
      accepted(ARKStepSetPostprocessStepFn(memory_, project), "the projection onto the constraints");
  }

  int degree() const override { return ARK_INTERP_MAX_DEGREE; }

private:
  int solve(double target) override { return ARKStepEvolve(memory_, target, at_.get(), &t_, ARK_ONE_STEP); }
  // ARKStepReset would keep the step size, but it finds no events afterward.
  int reinitialize() override { return ARKStepReInit(memory_, explicit_, implicit_, t_, at_.get()); }

  static int project(double t, N_Vector y, void* of) {
    arkode& a = *static_cast<arkode*>(static_cast<adaptive*>(of));
    a.correction_.resize(a.y_.size());
    const answer found = a.problem_.project(t, numbers_of(y), a.weights(), a.correction_.data(), nullptr);
    for (std::size_t i = 0; i < a.y_.size(); ++i) numbers_of(y)[i] += a.correction_[i];
    return static_cast<int>(found);
  }

  ARKRhsFn explicit_ = nullptr, implicit_ = nullptr;
};

} // namespace kanexpr::simulations
