#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulate/sundials/failure.hpp>

#include <vector>

namespace kanexpr::solvers {

struct stepper_options {
  double end = 0; ///< nothing is evaluated beyond it
  double relative_tolerance = 1e-8;
  std::vector<double> absolute_tolerances{}; ///< one for each entry
  double first_step = 0;                     ///< 0: the integrator chooses
  double least_step = 0;
  double greatest_step = 0; ///< 0: any
  bool analytic_jacobian = true;
};

enum class arrival { step, event, failed };

/// An integrator with adaptive steps, behind one face. Its times are those since the start.
class stepper {
public:
  virtual ~stepper() = default;

  /// What went wrong when it was made or in its last step.
  const failure& failed() const { return failed_; }

  /// Goes one step, or less to an event or to a target.
  virtual arrival advance(double target) = 0;
  /// Sets what errors are measured by from here on; of further entries nothing changes.
  virtual void set_tolerances(double relative, const std::vector<double>& absolute) = 0;
  /// Whether the states that it shows are brought to the constraints beside its own.
  virtual bool shows_projected() const { return false; }

  /// Where it stands: the end of its last step, the target or the event.
  double time() const { return t_; }
  int entries() const { return static_cast<int>(y_.size()); }
  double* state() { return y_.data(); }
  const double* state() const { return y_.data(); }
  /// The rates there, where the integrator keeps them; they are set before it goes on from another state.
  virtual double* rates() { return nullptr; }

  /// Whether a watched function passed zero: its sign there, 1 where it rises; 0: it did not.
  virtual std::vector<int> events() const = 0;

  /// The derivative of some order of the solution's polynomial over the last step.
  virtual bool derivative(double t, int order, double* out) = 0;
  /// The degree of that polynomial.
  virtual int degree() const = 0;
  /// Where the last step began and ended.
  virtual double step_begin() const = 0;
  virtual double step_end() const = 0;

  /// Leaves the way from an earlier time, of which `state` is given before it goes on.
  void go_back_to(double t) { t_ = t; }
  /// Goes on from what `state` was changed to.
  virtual bool restart() = 0;

  /// What it counts itself; evaluations of rates are counted by the problem.
  virtual integration_statistics statistics() const = 0;
  virtual long steps() const = 0;

protected:
  failure failed_{};
  double t_ = 0;
  std::vector<double> y_{};
};

} // namespace kanexpr::solvers
