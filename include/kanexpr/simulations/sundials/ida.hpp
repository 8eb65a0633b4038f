#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/sundials/adaptive.hpp>

#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

struct ida_calls {
  KANEXPR_SUNDIALS_CALLS(IDA, IDA);

  static constexpr bool is_evaluation(int flag) {
    return flag == IDA_RES_FAIL || flag == IDA_REP_RES_ERR || flag == IDA_FIRST_RES_FAIL;
  }
  static constexpr bool is_projection(int) { return false; }
};

/// Backward differentiation of a differential-algebraic system by IDA (Brenan, Campbell & Petzold 1996).
/// Entries whose rates appear in no equation, such as multipliers, are excluded from the error test.
class ida final : public adaptive<ida_calls, implicit_problem> {
public:
  ida(implicit_problem& problem, double from, std::vector<double> start, std::vector<double> start_rates,
      stepper_options options)
      : adaptive(problem, from, std::move(start), std::move(options)), ydot_(std::move(start_rates)) {
    if (base::equal(options_.first_step, 0.0)) options_.first_step = first_step();
    rates_at_ = vector_on(ydot_.data(), size(), context_);
    kinds_ = new_vector(size(), context_);
    memory_ = IDACreate(context_);
    if (!has_memory() || !rates_at_ || !kinds_) return;
    for (int i = 0; i < problem_.size(); ++i) numbers_of(kinds_.get())[i] = problem_.is_algebraic(i) ? 0 : 1;
    if (accepted(IDAInit(memory_, residual, t_, at_.get(), rates_at_.get()), "the first state") &&
        set_common() && accepted(IDASetId(memory_, kinds_.get()), "the algebraic entries") &&
        accepted(IDASetSuppressAlg(memory_, SUNTRUE), "the error test without algebraic entries"))
      set_newton(jacobian);
  }

  /// The reported state is projected onto the invariants that are not among the equations, and the drift of
  /// the formulas is gradually corrected.
  bool reports_projected_states() const override { return problem_.has_manifold(); }

  int degree() const override { return number<int>(IDAGetLastOrder); }

  double* rates() override { return ydot_.data(); }

private:
  /// Returns the rates as the equations define them.
  const double* without_drift_correction(const double* ydot) {
    if (drift_correction_.empty()) return ydot;
    plain_rates_.assign(ydot, ydot + y_.size());
    for (std::size_t i = 0; i < y_.size(); ++i) plain_rates_[i] -= drift_correction_[i];
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
  int reinitialize() override { return IDAReInit(memory_, t_, at_.get(), rates_at_.get()); }

  static ida& self(void* of) { return static_cast<ida&>(*static_cast<adaptive*>(of)); }
  static int residual(double t, N_Vector y, N_Vector ydot, N_Vector left, void* of) {
    ida& i = self(of);
    return static_cast<int>(i.problem_.residual(
        t, numbers_of(y), i.without_drift_correction(numbers_of(ydot)), numbers_of(left)));
  }
  static int jacobian(double t, double c, N_Vector y, N_Vector ydot, N_Vector, SUNMatrix j, void* of,
                      N_Vector, N_Vector, N_Vector) {
    ida& i = self(of);
    return static_cast<int>(i.problem_.jacobian(
        t, c, numbers_of(y), i.without_drift_correction(numbers_of(ydot)), SUNDenseMatrix_Data(j)));
  }

  std::vector<double> ydot_, plain_rates_{};
  vector_handle rates_at_{}, kinds_{};
};

} // namespace kanexpr::simulations
