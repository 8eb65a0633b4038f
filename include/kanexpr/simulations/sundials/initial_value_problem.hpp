#pragma once

/// The problems that integrators solve. Times are counted from the start.
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

  /// Whether the exact solution stays on a manifold that does not follow from the equations at each time.
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

} // namespace kanexpr::simulations
