#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/simulations/sundials/handles.hpp>
#include <kanexpr/simulations/sundials/stepper.hpp>

#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Defines static members that give the functions of a SUNDIALS package common names. `Prefix` is the prefix
/// of the package's functions, and `CODE` that of its return codes.
#define KANEXPR_SUNDIALS_CALLS(Prefix, CODE)                                                                 \
  static constexpr auto free = Prefix##Free;                                                                 \
  static constexpr auto set_error_handler = Prefix##SetErrHandlerFn;                                         \
  static constexpr auto set_user_data = Prefix##SetUserData;                                                 \
  static constexpr auto set_weights = Prefix##WFtolerances;                                                  \
  static constexpr auto set_first_step = Prefix##SetInitStep;                                                \
  static constexpr auto set_least_step = Prefix##SetMinStep;                                                 \
  static constexpr auto set_greatest_step = Prefix##SetMaxStep;                                              \
  static constexpr auto set_end = Prefix##SetStopTime;                                                       \
  static constexpr auto watch = Prefix##RootInit;                                                            \
  static constexpr auto set_directions = Prefix##SetRootDirection;                                           \
  static constexpr auto no_warnings = Prefix##SetNoInactiveRootWarn;                                         \
  static constexpr auto root_info = Prefix##GetRootInfo;                                                     \
  static constexpr auto derivative = Prefix##GetDky;                                                         \
  static constexpr auto last_step = Prefix##GetLastStep;                                                     \
  static constexpr auto next_step = Prefix##GetCurrentStep;                                                  \
  static constexpr auto current_time = Prefix##GetCurrentTime;                                               \
  static constexpr auto steps = Prefix##GetNumSteps;                                                         \
  static constexpr auto error_test_failures = Prefix##GetNumErrTestFails;                                    \
  static constexpr auto solver_failures = Prefix##GetNumStepSolveFails;                                      \
  static constexpr auto jacobians = Prefix##GetNumJacEvals;                                                  \
  static constexpr auto set_linear_solver = Prefix##SetLinearSolver;                                         \
  static constexpr auto set_jacobian = Prefix##SetJacFn;                                                     \
  static constexpr auto error_weights = Prefix##GetErrWeights;                                               \
  static constexpr int event_failed = CODE##_RTFUNC_FAIL

namespace kanexpr::simulations {

/// The common part of the SUNDIALS integrators. `Calls` names the functions of one of them, and `Problem` is
/// the form of the equations that it integrates.
template <class Calls, class Problem>
class adaptive : public stepper {
public:
  adaptive(const adaptive&) = delete;
  adaptive& operator=(const adaptive&) = delete;
  ~adaptive() override { Calls::free(&memory_); }

  arrival advance(double target) override {
    const arrival arrived = step(target);
    return arrived == arrival::failed || correct() ? arrived : arrival::failed;
  }

  bool restart() override {
    drift_correction_.clear();
    before_restart_ = statistics(); // a restart may clear the counters
    return accepted(reinitialize(), "a new state") && set_end();
  }

  void set_tolerances(double relative, const std::vector<double>& absolute) override {
    options_.relative_tolerance = relative;
    std::ranges::copy(absolute, options_.absolute_tolerances.begin());
  }

  std::vector<int> events() const override {
    std::vector<int> found(static_cast<std::size_t>(problem_.watched()));
    Calls::root_info(memory_, found.data());
    return found;
  }

  bool derivative(double t, int order, double* out) override {
    const vector_handle v = vector_on(out, size(), context_);
    return Calls::derivative(memory_, t, order, v.get()) == 0;
  }
  double step_begin() const override { return step_end() - number(Calls::last_step); }
  double step_end() const override { return number(Calls::current_time); }

  integration_statistics statistics() const override {
    integration_statistics all = before_restart_;
    all.steps += number<long>(Calls::steps);
    all.error_test_failures += number<long>(Calls::error_test_failures);
    all.solver_failures += number<long>(Calls::solver_failures);
    if (solver_) all.jacobian_evaluations += number<long>(Calls::jacobians);
    return all;
  }

protected:
  static constexpr int root_return = 2;         // the same in all three packages
  static constexpr double steps_of_return = 10; // fewer would affect the error test

  adaptive(Problem& problem, double from, std::vector<double> start, stepper_options options)
      : problem_(problem), options_(std::move(options)) {
    t_ = from;
    y_ = std::move(start);
    at_ = vector_on(y_.data(), size(), context_);
    weights_ = new_vector(size(), context_);
  }

  /// Calls the integrator once; it advances t and y.
  virtual int solve(double target) = 0;
  virtual int reinitialize() = 0;

  sunindextype size() const { return static_cast<sunindextype>(y_.size()); }

  bool has_memory() {
    if (memory_ != nullptr && at_ && weights_)
      return accepted(Calls::set_error_handler(memory_, last_error::handle, &error_), "an error handler");
    failure_ = "there is no memory left for the integrator";
    return false;
  }

  /// Applies the settings that all integrators share, after the first state is set.
  bool set_common() {
    return accepted(Calls::set_user_data(memory_, this), "the user data") &&
           accepted(Calls::set_weights(memory_, compute_weights), "the tolerances") &&
           accepted(Calls::set_first_step(memory_, options_.first_step), "the first step") &&
           accepted(Calls::set_least_step(memory_, options_.least_step), "the least step") &&
           accepted(Calls::set_greatest_step(memory_, options_.greatest_step), "the greatest step") &&
           set_end() && set_watched();
  }
  bool set_end() { return accepted(Calls::set_end(memory_, options_.end), "the end of the time span"); }

  bool accepted(int flag, const char* what) {
    if (flag == 0) return true;
    failure_ = error_.after(std::string("SUNDIALS rejected ") + what);
    return false;
  }

  /// Selects Newton's method with dense matrices, and the problem's own Jacobian if it has one.
  template <class Jacobian>
  bool set_newton(Jacobian callback) {
    matrix_.reset(SUNDenseMatrix(size(), size(), context_));
    solver_.reset(SUNLinSol_Dense(at_.get(), matrix_.get(), context_));
    if (!accepted(Calls::set_linear_solver(memory_, solver_.get(), matrix_.get()), "the linear solver"))
      return false;
    return !options_.analytic_jacobian || !problem_.has_jacobian() ||
           accepted(Calls::set_jacobian(memory_, callback), "the Jacobian");
  }

  /// Returns a number that the integrator reports; 0 if it has none.
  template <class Number = double, class Get>
  Number number(Get get) const {
    Number found = 0;
    return get(memory_, &found) == 0 ? found : 0;
  }

  /// The callbacks of integrators of explicit problems.
  static int rates(double t, N_Vector y, N_Vector ydot, void* of) {
    adaptive& self = *static_cast<adaptive*>(of);
    const answer found = self.problem_.rates(t, numbers_of(y), numbers_of(ydot));
    for (std::size_t i = 0; i < self.drift_correction_.size(); ++i)
      numbers_of(ydot)[i] += self.drift_correction_[i];
    return static_cast<int>(found);
  }
  static int jacobian(double t, N_Vector y, N_Vector, SUNMatrix j, void* of, N_Vector, N_Vector, N_Vector) {
    return static_cast<int>(
        static_cast<adaptive*>(of)->problem_.jacobian(t, numbers_of(y), SUNDenseMatrix_Data(j)));
  }

  const double* weights() {
    Calls::error_weights(memory_, weights_.get());
    return numbers_of(weights_.get());
  }

  Problem& problem_;
  stepper_options options_;
  ::sundials::Context context_{};
  vector_handle at_{}, weights_{};
  matrix_handle matrix_{};
  linear_solver_handle solver_{};
  void* memory_ = nullptr;
  std::vector<double> correction_{};
  std::vector<double> drift_correction_{}; ///< toward the manifold; added to the rates

private:
  bool is_at(double target) const {
    const double latest = (std::max)(std::abs(t_), std::abs(target));
    return target - t_ <= 8 * std::numeric_limits<double>::epsilon() * latest;
  }

  arrival step(double target) {
    if (is_at(target)) { // for example after an event, where SUNDIALS would reject the target as too close
      t_ = target;
      return arrival::step;
    }
    const int flag = solve(target);
    if (flag < 0) {
      failure_ = failure_for(flag);
      return arrival::failed;
    }
    return flag == root_return ? arrival::event : arrival::step;
  }

  /// Projects the reported state onto a manifold from which the formulas drift, unless the integrator does so
  /// itself. A term added to the rates returns the formulas to the manifold over the next steps; if they were
  /// restarted from a corrected state, they would begin at low orders, which drift fastest.
  bool correct() {
    if (!reports_projected_states()) return true;
    correction_.assign(y_.size(), 0);
    if (problem_.project(t_, y_.data(), weights(), correction_.data(), nullptr) != answer::success) {
      failure_ = "the state could not be brought back to the constraints";
      return false;
    }
    const double way = steps_of_return * (std::max)(number(Calls::last_step), number(Calls::next_step));
    drift_correction_.assign(y_.size(), 0);
    for (std::size_t i = 0; i < y_.size(); ++i) {
      y_[i] += correction_[i];
      if (way > 0) drift_correction_[i] = correction_[i] / way;
    }
    return true;
  }

  bool set_watched() {
    const int count = problem_.watched();
    if (count == 0) return true;
    std::vector<int> directions(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) directions[static_cast<std::size_t>(i)] = problem_.direction(i);
    return accepted(Calls::watch(memory_, count, watch), "the events") &&
           accepted(Calls::set_directions(memory_, directions.data()), "the directions of the events") &&
           accepted(Calls::no_warnings(memory_), "the suppression of warnings");
  }

  /// Computes weights from tolerances that may change between two steps.
  static int compute_weights(N_Vector y, N_Vector weights, void* of) {
    const stepper_options& o = static_cast<adaptive*>(of)->options_;
    for (std::size_t i = 0; i < o.absolute_tolerances.size(); ++i) {
      const double unit = o.relative_tolerance * std::abs(numbers_of(y)[i]) + o.absolute_tolerances[i];
      if (!(unit > 0)) return -1;
      numbers_of(weights)[i] = 1 / unit;
    }
    return 0;
  }

  static int watch(double t, N_Vector y, double* values, void* of) {
    return static_cast<int>(static_cast<adaptive*>(of)->problem_.watch(t, numbers_of(y), values));
  }
  static int watch(double t, N_Vector y, N_Vector, double* values, void* of) {
    return watch(t, y, values, of);
  }

  /// Returns the end of an error message about the least step; empty if only rounding limits the step size.
  std::string step_limit_text() const {
    if (options_.least_step <= 4 * std::numeric_limits<double>::epsilon() * options_.end) return {};
    return "; the least step is " + base::digits(options_.least_step);
  }

  /// Codes from −2 to −7 have the same meaning in all three packages.
  std::string failure_for(int flag) const {
    switch (flag) {
    case -2: return "the tolerances are too small for double precision";
    case -3:
      return "the step size collapsed: no step was short enough to keep the error within the tolerances" +
             step_limit_text();
    case -4:
      return "the step size collapsed: the iteration within a step did not converge" + step_limit_text();
    case -5:
    case -6:
    case -7: return "the linear equations within a step could not be solved";
    default: break;
    }
    if (flag == Calls::event_failed) return "an event could not be evaluated";
    if (Calls::is_projection(flag)) return "the state could not be brought back to the constraints";
    if (Calls::is_evaluation(flag)) return "the equations of motion could not be evaluated";
    return "SUNDIALS failed: " + error_.message;
  }

  last_error error_{};
  integration_statistics before_restart_{};
};

} // namespace kanexpr::simulations
