#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/sundials/adaptive.hpp>

#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <algorithm>
#include <cmath>

namespace kanexpr::solvers {

struct ida_calls {
  static constexpr auto free = IDAFree;
  static constexpr auto set_error_handler = IDASetErrHandlerFn;
  static constexpr auto set_user_data = IDASetUserData;
  static constexpr auto set_weights = IDAWFtolerances;
  static constexpr auto set_first_step = IDASetInitStep;
  static constexpr auto set_least_step = IDASetMinStep;
  static constexpr auto set_greatest_step = IDASetMaxStep;
  static constexpr auto set_end = IDASetStopTime;
  static constexpr auto watch = IDARootInit;
  static constexpr auto set_directions = IDASetRootDirection;
  static constexpr auto no_warnings = IDASetNoInactiveRootWarn;
  static constexpr auto root_info = IDAGetRootInfo;
  static constexpr auto derivative = IDAGetDky;
  static constexpr auto last_step = IDAGetLastStep;
  static constexpr auto next_step = IDAGetCurrentStep;
  static constexpr auto current_time = IDAGetCurrentTime;
  static constexpr auto steps = IDAGetNumSteps;
  static constexpr auto error_test_failures = IDAGetNumErrTestFails;
  static constexpr auto solver_failures = IDAGetNumStepSolveFails;
  static constexpr auto jacobians = IDAGetNumJacEvals;
  static constexpr auto set_linear_solver = IDASetLinearSolver;
  static constexpr auto set_jacobian = IDASetJacFn;
  static constexpr auto error_weights = IDAGetErrWeights;

  static constexpr int event_failed = IDA_RTFUNC_FAIL;
  static constexpr bool is_evaluation(int flag) {
    return flag == IDA_RES_FAIL || flag == IDA_REP_RES_ERR || flag == IDA_FIRST_RES_FAIL;
  }
  static constexpr bool is_projection(int) { return false; }
};

/// Backward differentiation of a differential-algebraic system by IDA (Brenan, Campbell & Petzold 1996).
/// Entries whose rates appear in no equation, such as multipliers, are excluded from the error test.
class ida final : public adaptive<ida_calls> {
public:
  ida(implicit_problem& problem, double from, std::vector<double> start, std::vector<double> start_rates,
      stepper_options options)
      : adaptive(problem, from, std::move(start), std::move(options)), problem_(problem),
        ydot_(std::move(start_rates)) {
    if (numeric::equal(options_.first_step, 0.0)) options_.first_step = first_step();
    rates_at_ = vector_on(ydot_.data(), size(), context_);
    kinds_ = new_vector(size(), context_);
    memory_ = IDACreate(context_);
    if (!has_memory() || !rates_at_ || !kinds_) return;
    for (int i = 0; i < problem_.size(); ++i) numbers_of(kinds_.get())[i] = problem_.is_algebraic(i) ? 0 : 1;
    if (done(IDAInit(memory_, residual, t_, at_.get(), rates_at_.get()), "the first state") && set_common() &&
        done(IDASetId(memory_, kinds_.get()), "the algebraic entries") &&
        done(IDASetSuppressAlg(memory_, SUNTRUE), "the error test without algebraic entries"))
      set_newton(problem_, jacobian);
  }

  bool shows_projected() const override { return problem_.has_invariants(); }

  /// Projects the reported state onto the invariants that are not among the equations, and leads back the
  /// drift of the formulas.
  arrival advance(double target) override {
    const arrival at = adaptive::advance(target);
    return at == arrival::failed || !problem_.has_invariants() || keep_invariants() ? at : arrival::failed;
  }

  int degree() const override {
    int order = 0;
    IDAGetLastOrder(memory_, &order);
    return order;
  }

  double* rates() override { return ydot_.data(); }

  bool restart() override {
    way_back_.clear();
    keep_counts();
    return done(IDAReInit(memory_, t_, at_.get(), rates_at_.get()), "a new state") && set_end();
  }

private:
  bool keep_invariants() {
    return correct([&](double t, const double* y, const double* weights, double* correction) {
      return problem_.project(t, y, weights, correction);
    });
  }

  /// Returns the rates as the equations define them.
  const double* without_way_back(const double* ydot) {
    if (way_back_.empty()) return ydot;
    plain_rates_.assign(ydot, ydot + y_.size());
    for (std::size_t i = 0; i < y_.size(); ++i) plain_rates_[i] -= way_back_[i];
    return plain_rates_.data();
  }

  /// Returns a hundredth of the time in which the state would change by its own magnitude, measured in
  /// tolerances (Hairer, Nørsett & Wanner, II.4). IDA's own estimate requires a change of less than a
  /// tolerance, which is too small for double precision.
  double first_step() const {
    double size_of_state = 0, size_of_rates = 0;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      if (problem_.is_algebraic(static_cast<int>(i))) continue;
      const double unit = options_.relative_tolerance * std::abs(y_[i]) + options_.absolute_tolerances[i];
      size_of_state += (y_[i] / unit) * (y_[i] / unit);
      size_of_rates += (ydot_[i] / unit) * (ydot_[i] / unit);
    }
    const double guess = 0.01 * std::sqrt(size_of_state / size_of_rates);
    return numeric::is_finite(guess) && guess > 0 ? (std::min)(guess, 1e-3 * (options_.end - t_)) : 0;
  }

  int solve(double target) override {
    return IDASolve(memory_, target, &t_, at_.get(), rates_at_.get(), IDA_ONE_STEP);
  }

  static ida& self(void* of) { return static_cast<ida&>(*static_cast<adaptive*>(of)); }
  static int residual(double t, N_Vector y, N_Vector ydot, N_Vector left, void* of) {
    ida& i = self(of);
    return static_cast<int>(
        i.problem_.residual(t, numbers_of(y), i.without_way_back(numbers_of(ydot)), numbers_of(left)));
  }
  static int jacobian(double t, double c, N_Vector y, N_Vector ydot, N_Vector, SUNMatrix j, void* of,
                      N_Vector, N_Vector, N_Vector) {
    ida& i = self(of);
    return static_cast<int>(i.problem_.jacobian(t, c, numbers_of(y), i.without_way_back(numbers_of(ydot)),
                                                SUNDenseMatrix_Data(j)));
  }

  implicit_problem& problem_;
  std::vector<double> ydot_, plain_rates_{};
  vector_handle rates_at_{}, kinds_{};
};

} // namespace kanexpr::solvers
