#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulations/sundials/failure.hpp>

#include <vector>

namespace kanexpr::simulations {

struct stepper_options {
  double end = 0; ///< nothing is evaluated beyond it
  double relative_tolerance = 1e-8;
  std::vector<double> absolute_tolerances{}; ///< one for each entry
  double first_step = 0;                     ///< 0: the integrator chooses
  double least_step = 0;
  double greatest_step = 0; ///< 0: no limit
  bool analytic_jacobian = true;
};

enum class arrival { step, event, failed };

/// The common interface of integrators with adaptive steps. Times are counted from the start.
class stepper {
public:
  virtual ~stepper() = default;

  /// Returns the failure of the construction or of the last step.
  const failure& failed() const { return failed_; }

  /// Takes one step, or a shorter one up to an event or a target.
  virtual arrival advance(double target) = 0;
  /// Sets the tolerances from here on; those of further entries do not change.
  virtual void set_tolerances(double relative, const std::vector<double>& absolute) = 0;
  /// Whether the reported states are projected onto the constraints separately from the integrator's own
  /// states.
  virtual bool reports_projected_states() const { return false; }

  /// Returns the current time: the end of the last step, the target or the event.
  double time() const { return t_; }
  int entries() const { return static_cast<int>(y_.size()); }
  double* state() { return y_.data(); }
  const double* state() const { return y_.data(); }
  /// Returns the rates at that time if the integrator keeps them; they must be set before it continues from a
  /// different state.
  virtual double* rates() { return nullptr; }

  /// Returns for each watched function 1 if it crossed zero rising, −1 if falling, 0 if it did not pass zero.
  virtual std::vector<int> events() const = 0;

  /// Evaluates a derivative of the solution's polynomial over the last step, of any order.
  virtual bool derivative(double t, int order, double* out) = 0;
  /// Returns the degree of that polynomial.
  virtual int degree() const = 0;
  /// Return the times at which the last step began and ended.
  virtual double step_begin() const = 0;
  virtual double step_end() const = 0;

  /// Goes back to an earlier time; `state` must be set before the integration continues.
  void go_back_to(double t) { t_ = t; }
  /// Restarts from the changed `state`.
  virtual bool restart() = 0;

  /// Returns the integrator's own counters; the problem counts evaluations of rates.
  virtual integration_statistics statistics() const = 0;
  virtual long steps() const = 0;

protected:
  failure failed_{};
  double t_ = 0;
  std::vector<double> y_{};
};

} // namespace kanexpr::simulations
