#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/simulate/trajectory/dense_output.hpp>

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace kanexpr {

namespace simulated {

class manifold;
class system_interface;

using manifold_factory = std::unique_ptr<manifold> (*)(const system_interface&);
/// Returns the manifold of a system with constraints or quaternions.
template <class System>
std::unique_ptr<manifold> manifold_of(const System& of);

/// The interface of a system in a simulation: its survey, and functions over plain arrays in the order of its
/// vectors. Implementations add its parameters and options. Code that uses only this interface does not
/// depend on the model and is compiled without it.
class system_interface {
public:
  system_interface(const deriving::survey& of, const describe::system_record& of_record,
                   std::string_view called, manifold_factory maker)
      : known(of), record(of_record), name(called), create_manifold(maker) {}
  virtual ~system_interface() = default;

  const deriving::survey& known;
  const describe::system_record& record;
  std::string_view name;
  manifold_factory create_manifold; ///< null if there are no constraints and no quaternions

  int states() const { return known.coordinates + known.speeds; }

  /// Evaluates ẋ.
  virtual status rates(double t, const double* x, const double* r, double* xdot) const = 0;
  /// Evaluates ∂ẋ/∂x and ∂ẋ/∂r in column-major order, for methods with Newton's iteration.
  virtual status jacobian(double t, const double* x, const double* r, double* by_state,
                          double* by_inputs) const = 0;
  /// Evaluates the residuals of the configuration constraints and their derivatives with respect to all
  /// coordinates, in column-major order.
  virtual void configuration(double t, const double* x, const double* r, double* left,
                             double* by_coordinates) const = 0;
  /// Evaluates the residuals of the velocity constraints and their derivatives with respect to all speeds, in
  /// column-major order.
  virtual void velocities(double t, const double* x, const double* r, double* left,
                          double* by_speeds) const = 0;
  /// Evaluates the residuals of the redundant constraints and the magnitudes of their terms; then the same
  /// for their rates.
  virtual void redundant(double t, const double* x, const double* r, double* left, double* terms,
                         double* rate, double* rate_terms) const = 0;
  virtual status dependent_speeds(double t, const double* x, const double* r, double* u) const = 0;

  /// Evaluates q̇ and the terms of the equations of all speeds, M u̇ = f + Jᵀ λ with J u̇ + γ = 0.
  virtual status unreduced(double t, const double* x, const double* r, double* qdot, double* mass,
                           double* force, double* bias) const = 0;

  /// For the method with multipliers: evaluates λ, and F(t, y, ẏ) in y = [q; u; λ; μ].
  virtual void multipliers(double t, const double* x, const double* r, double* lambda) const = 0;
  virtual status implicit(double t, const double* y, const double* ydot, const double* r,
                          double* left) const = 0;
  virtual status implicit(double t, const std::complex<double>* y, const std::complex<double>* ydot,
                          const std::complex<double>* r, std::complex<double>* left) const = 0;

  /// The user's functions, which may throw.
  virtual void evaluate_inputs(double t, const double* x, double* r) const = 0;
  /// Returns an independent copy of the input function if rates of prescribed quantities are among the
  /// inputs. The copy has its own state between calls.
  virtual std::function<void(double t, const double* x, double* r)> copy_of_inputs() const = 0;
  virtual double event(std::size_t which, double t, const double* x, const double* r) const = 0;
  virtual after_event handle(std::size_t which, double t, double* x, const double* r) const = 0;
  virtual void pass_sample(double t, const double* x, const double* r) const = 0;
  /// Store a sample and a polynomial.
  virtual void store_sample(double t, const double* x, const double* r) = 0;
  virtual void store_polynomial(piece p) = 0;
};

} // namespace simulated

} // namespace kanexpr
