#pragma once

/// What integrators ask of the system that they move, at times since the start.
namespace kanexpr::solvers {

/// As SUNDIALS takes it from a function of its user.
enum class answer : int {
  never = -1, ///< the integration must end
  given = 0,
  not_here = 1, ///< the integrator may try again nearer to where it was
};

/// Functions of time that are watched for zeros; the moving states are `y`.
class watched_problem {
public:
  virtual ~watched_problem() = default;

  virtual int size() const = 0;
  virtual int watched() const { return 0; }
  virtual answer watch(double t, const double* y, double* values) = 0;
  /// For each watched function: 1 looks for zeros where it rises, −1 where it falls, 0 for both.
  virtual int direction(int watched) const = 0;
};

/// ẏ = f(t, y), on a manifold that the exact solution does not leave.
class explicit_problem : public watched_problem {
public:
  virtual answer rates(double t, const double* y, double* ydot) = 0;
  /// ∂f/∂y by columns.
  virtual answer jacobian(double t, const double* y, double* columns) = 0;
  virtual bool has_jacobian() const = 0;

  virtual bool has_constraints() const = 0;
  /// What leads from `y` to the nearest point of the manifold, with 1/`weights` as the unit of each entry; an
  /// error estimate, if given, loses what points away from the manifold.
  virtual answer project(double t, const double* y, const double* weights, double* correction,
                         double* error) = 0;
};

/// F(t, y, ẏ) = 0.
class implicit_problem : public watched_problem {
public:
  virtual answer residual(double t, const double* y, const double* ydot, double* left) = 0;
  /// ∂F/∂y + c ∂F/∂ẏ by columns.
  virtual answer jacobian(double t, double c, const double* y, const double* ydot, double* columns) = 0;
  virtual bool has_jacobian() const = 0;
  /// Whether an entry of y is one whose rate is in no equation.
  virtual bool is_algebraic(int entry) const = 0;

  /// Whether the exact solution keeps to more than the equations say.
  virtual bool has_invariants() const = 0;
  /// What leads from `y` to the nearest point that keeps to it, with 1/`weights` as the unit of each entry.
  virtual answer project(double t, const double* y, const double* weights, double* correction) = 0;
};

} // namespace kanexpr::solvers
