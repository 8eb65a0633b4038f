#pragma once

#include <kanexpr/base/statistics.hpp>

#include <string>
#include <vector>

/// Integrators with adaptive steps and the problems that they solve. Times are counted from the start.

namespace kanexpr::simulations {

/// The return value that SUNDIALS expects from a user function.
enum class answer : int {
  unrecoverable = -1, ///< the integration must end
  success = 0,
  recoverable = 1, ///< the integrator may retry with a smaller step
};

/// The part of a problem that does not depend on the form of its equations; `y` denotes the state.
class initial_value_problem {
public:
  virtual ~initial_value_problem() = default;

  virtual int size() const = 0;
  /// Returns the number of functions that are watched for zeros along the motion.
  virtual int watched() const { return 0; }
  virtual answer watch(double t, const double* y, double* values) = 0;
  /// Returns, for a watched function, 1 to detect zeros where it rises, −1 where it falls, 0 for both.
  virtual int direction(int watched) const = 0;
  virtual bool has_jacobian() const = 0;

  /// Whether the exact solution stays on a manifold that the equations at a single time do not enforce.
  virtual bool has_manifold() const = 0;
  /// Finds the correction from `y` to the nearest point on the manifold, with 1/`weights` as the unit of each
  /// entry; removes the component normal to the manifold from an error estimate, if one is given.
  virtual answer project(double t, const double* y, const double* weights, double* correction,
                         double* error) = 0;
};

/// ẏ = f(t, y).
class explicit_problem : public initial_value_problem {
public:
  virtual answer rates(double t, const double* y, double* ydot) = 0;
  /// Evaluates ∂f/∂y in column-major order.
  virtual answer jacobian(double t, const double* y, double* columns) = 0;
};

/// F(t, y, ẏ) = 0.
class implicit_problem : public initial_value_problem {
public:
  virtual answer residual(double t, const double* y, const double* ydot, double* left) = 0;
  /// Evaluates ∂F/∂y + c ∂F/∂ẏ in column-major order.
  virtual answer jacobian(double t, double c, const double* y, const double* ydot, double* columns) = 0;
  /// Whether the rate of an entry of y appears in no equation.
  virtual bool is_algebraic(int entry) const = 0;
};

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

/// The common interface of integrators with adaptive steps.
class stepper {
public:
  virtual ~stepper() = default;

  /// Returns the cause of a failure of the construction or of the last step, as a sentence; empty if there
  /// was none.
  const std::string& failure() const { return failure_; }

  /// Takes one step, which ends early at an event or a target.
  virtual arrival advance(double target) = 0;
  /// Sets the tolerances for the following steps. Entries beyond the given ones keep theirs.
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

  /// Returns, for each watched function, 1 if it crossed zero while rising, −1 while falling, and 0 if it did
  /// not cross zero.
  virtual std::vector<int> events() const = 0;

  /// Evaluates a derivative of any order of the solution's polynomial over the last step.
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

protected:
  std::string failure_{};
  double t_ = 0;
  std::vector<double> y_{};
};

} // namespace kanexpr::simulations
