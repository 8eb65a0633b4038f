#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/simulate/dense_output.hpp>

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace kanexpr {

namespace simulated {

class manifold;
class system;

using manifold_maker = std::unique_ptr<manifold> (*)(const system&);
/// The manifold of a system with constraints or quaternions.
template <class System>
std::unique_ptr<manifold> manifold_of(const System& of);

/// A system as a simulation sees it: its survey, functions over plain arrays in the order of its vectors, and
/// behind them its parameters and what its user wants. Whatever works through this face alone knows no model,
/// and is compiled without one.
class system {
public:
  system(const deriving::survey& of, const describe::system_record& record, std::string_view called,
         manifold_maker maker)
      : known(of), told(record), name(called), make_manifold(maker) {}
  virtual ~system() = default;

  const deriving::survey& known;
  const describe::system_record& told;
  std::string_view name;
  manifold_maker make_manifold; ///< null: there are no constraints, and no quaternions

  int states() const { return known.coordinates + known.speeds; }

  /// ẋ.
  virtual status rates(double t, const double* x, const double* r, double* xdot) const = 0;
  /// ∂ẋ/∂x and ∂ẋ/∂r by columns, for methods with Newton's iteration.
  virtual status jacobian(double t, const double* x, const double* r, double* by_state,
                          double* by_inputs) const = 0;
  /// What the configuration constraints leave, and its derivatives by all coordinates, by columns.
  virtual void configuration(double t, const double* x, const double* r, double* left,
                             double* by_coordinates) const = 0;
  /// What the constraints on speeds leave, and its derivatives by all speeds, by columns.
  virtual void velocities(double t, const double* x, const double* r, double* left,
                          double* by_speeds) const = 0;
  /// What the redundant constraints leave, and how large their terms are; then the same of their rates.
  virtual void redundant(double t, const double* x, const double* r, double* left, double* terms,
                         double* rate, double* rate_terms) const = 0;
  virtual status dependent_speeds(double t, const double* x, const double* r, double* u) const = 0;

  /// What the equations of all speeds are made of, M u̇ = f + Jᵀ λ with J u̇ + γ = 0; and q̇.
  virtual status unreduced(double t, const double* x, const double* r, double* qdot, double* mass,
                           double* force, double* bias) const = 0;

  /// For the method with multipliers: λ, and F(t, y, ẏ) in y = [q; u; λ; μ].
  virtual void multipliers(double t, const double* x, const double* r, double* lambda) const = 0;
  virtual status implicit(double t, const double* y, const double* ydot, const double* r,
                          double* left) const = 0;
  virtual status implicit(double t, const std::complex<double>* y, const std::complex<double>* ydot,
                          const std::complex<double>* r, std::complex<double>* left) const = 0;

  /// The functions of the user, which may throw.
  virtual void give_inputs(double t, const double* x, double* r) const = 0;
  /// A function of its own that gives the inputs, where rates of prescribed quantities are among them: what
  /// the user's function keeps from call to call is its copy's.
  virtual std::function<void(double t, const double* x, double* r)> copy_of_inputs() const = 0;
  virtual double event(std::size_t which, double t, const double* x, const double* r) const = 0;
  virtual after_event handle(std::size_t which, double t, double* x, const double* r) const = 0;
  virtual void show(double t, const double* x, const double* r) const = 0;
  /// Keeps a sample, and a polynomial.
  virtual void keep(double t, const double* x, const double* r) = 0;
  virtual void keep(piece p) = 0;
};

} // namespace simulated

} // namespace kanexpr
