#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/simulations/integrator.hpp>
#include <kanexpr/simulations/trajectory/dense_output.hpp>

#include <complex>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string_view>

namespace kanexpr {

namespace simulations {

class manifold;
class system_interface;

using manifold_factory = std::unique_ptr<manifold> (*)(const system_interface&);
/// Returns the manifold of a system with constraints or quaternions.
template <class System>
std::unique_ptr<manifold> manifold_of(const System& of);

/// The results of a system that its simulation evaluates together, in the order in which they are derived.
enum class results : unsigned char {
  rates,         ///< ẋ
  configuration, ///< the residuals of the configuration constraints; their derivatives by all coordinates
  redundant,     ///< the residuals of the redundant constraints and the magnitudes of their terms; the same
                 ///< for their rates
  velocities,    ///< the residuals of the velocity constraints; their derivatives by all speeds
  dependent_speeds, ///< the dependent speeds
  unreduced,        ///< q̇, and the terms of the equations of all speeds, M u̇ = f + Jᵀ λ with J u̇ + γ = 0
  jacobian,         ///< ∂ẋ/∂x and ∂ẋ/∂r, for methods with Newton's iteration
  multipliers,      ///< λ, for the method with multipliers
};

struct result_list {
  std::size_t size;
  mechanics::quantity quantities[4];
};
/// The quantities of all results.
inline constexpr result_list lists_of_results[] = {
    {1, {mechanics::quantity::rhs}},
    {2, {mechanics::quantity::configuration_residual, mechanics::quantity::configuration_jacobian_by_all}},
    {4,
     {mechanics::quantity::redundant_residual, mechanics::quantity::redundant_terms,
      mechanics::quantity::redundant_rate, mechanics::quantity::redundant_rate_terms}},
    {2, {mechanics::quantity::velocity_residual, mechanics::quantity::constraint_jacobian}},
    {1, {mechanics::quantity::dependent_speeds}},
    {4,
     {mechanics::quantity::qdot, mechanics::quantity::unreduced_mass_matrix,
      mechanics::quantity::unreduced_forcing, mechanics::quantity::constraint_bias}},
    {2, {mechanics::quantity::state_jacobian, mechanics::quantity::input_jacobian}},
    {1, {mechanics::quantity::multipliers}},
};
constexpr const result_list& list_of(results r) { return lists_of_results[static_cast<std::size_t>(r)]; }

constexpr bool has_newton(integrator by) {
  return by == integrator::bdf || by == integrator::implicit_runge_kutta;
}

constexpr bool is_needed(results wanted, const derivation::survey& known, integrator by) {
  switch (wanted) {
  case results::rates: return true;
  case results::configuration: return known.configuration_constraints != 0;
  case results::redundant: return known.redundant_constraints != 0;
  case results::jacobian: return has_newton(by);
  case results::multipliers: return by == integrator::differential_algebraic && known.constraints != 0;
  default: return known.constraints != 0;
  }
}

using outputs = std::initializer_list<double*>;

/// The part of a system that does not change.
struct system_description {
  const derivation::survey& known;
  const describe::system_record& record;
  std::string_view name;
  manifold_factory create_manifold; ///< null if there are no constraints and no quaternions
};

/// The interface of a system in a simulation: its survey, and functions over plain arrays in the order of its
/// vectors. Implementations add its parameters and options. Code that uses only this interface does not
/// depend on the model and is compiled without it.
class system_interface {
public:
  explicit system_interface(const system_description& of)
      : known(of.known), record(of.record), name(of.name), create_manifold(of.create_manifold) {}
  virtual ~system_interface() = default;

  int states() const { return known.coordinates + known.speeds; }

  /// Evaluates results at a time, a state and inputs, each in column-major order. Results that the method or
  /// the system does not need are left as they are.
  virtual status evaluate(results wanted, double t, const double* x, const double* r, outputs into) const = 0;

  /// For the method with multipliers: evaluates F(t, y, ẏ) in y = [q; u; λ; μ].
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

  const derivation::survey& known;
  const describe::system_record& record;
  std::string_view name;
  manifold_factory create_manifold; ///< null if there are no constraints and no quaternions
};

} // namespace simulations

} // namespace kanexpr
