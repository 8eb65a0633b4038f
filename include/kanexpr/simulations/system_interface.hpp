#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/trajectory/samples.hpp>

#include <complex>
#include <cstddef>
#include <exception>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string_view>

namespace kanexpr::simulations {

class manifold;
class system_interface;

using manifold_factory = std::unique_ptr<manifold> (*)(const system_interface&);
/// Returns the manifold of a system with constraints or quaternions.
template <class System>
std::unique_ptr<manifold> manifold_of(const System& of);

/// The results of a system that its simulation evaluates together, in the order in which they are derived.
enum class results : unsigned char {
  rates,         ///< ẋ
  configuration, ///< the residuals of the configuration constraints; their derivatives with respect to the
                 ///< coordinates
  redundant,     ///< the residuals of the redundant constraints and the magnitudes of their terms; the same
                 ///< for their rates
  velocities,    ///< the residuals of the velocity constraints; their derivatives with respect to the speeds
  dependent_speeds, ///< the dependent speeds
  unreduced,        ///< q̇, and the terms of the equations for all speeds, M u̇ = f + Jᵀ λ with J u̇ + γ = 0
  jacobian,         ///< ∂ẋ/∂x and ∂ẋ/∂r, for methods that use Newton's iteration
  multipliers,      ///< λ; these and the next two are for the method with multipliers
  coordinate_rates, ///< q̇
  forces,           ///< F_r + F_r* for all speeds, for the given u̇
};

using mechanics::quantity;

struct result_list {
  std::size_t size;
  quantity quantities[4];
};
/// The quantities of all results.
inline constexpr result_list lists_of_results[] = {
    {1, {quantity::rhs}},
    {2, {quantity::configuration_residual, quantity::configuration_jacobian_by_all}},
    {4,
     {quantity::redundant_residual, quantity::redundant_terms, quantity::redundant_rate,
      quantity::redundant_rate_terms}},
    {2, {quantity::velocity_residual, quantity::constraint_jacobian}},
    {1, {quantity::dependent_speeds}},
    {4,
     {quantity::qdot, quantity::unreduced_mass_matrix, quantity::unreduced_forcing,
      quantity::constraint_bias}},
    {2, {quantity::state_jacobian, quantity::input_jacobian}},
    {1, {quantity::multipliers}},
    {1, {quantity::qdot}},
    {1, {quantity::unreduced_forces}},
};
constexpr const result_list& list_of(results r) { return lists_of_results[static_cast<std::size_t>(r)]; }

constexpr bool has_newton(integrator by) {
  return by == integrator::bdf || by == integrator::implicit_runge_kutta;
}

/// Whether a method evaluates a result of a system in real arithmetic.
constexpr bool is_needed(results wanted, const derivation::survey& known, integrator by) {
  const bool is_implicit = by == integrator::differential_algebraic;
  switch (wanted) {
  case results::rates: return true;
  case results::configuration: return known.configuration_constraints != 0;
  case results::redundant: return known.redundant_constraints != 0;
  case results::jacobian: return has_newton(by);
  case results::multipliers: return is_implicit && known.constraints != 0;
  case results::coordinate_rates:
  case results::forces: return is_implicit;
  default: return known.constraints != 0;
  }
}
/// The same for complex numbers, which the method with multipliers uses for its derivatives.
constexpr bool is_needed_in_complex(results wanted, const derivation::survey& known, integrator by) {
  return by == integrator::differential_algebraic && is_needed(wanted, known, by) &&
         (wanted == results::configuration || wanted == results::velocities ||
          wanted == results::coordinate_rates || wanted == results::forces);
}

/// The arguments of a result: a time, a state, inputs and, for `results::forces`, u̇.
template <class Number>
struct instant {
  double t;
  const Number *x, *r, *udot = nullptr;
};
template <class Number>
using outputs = std::initializer_list<Number*>;

/// The part of a system that does not change.
struct system_description {
  const derivation::survey& known;
  const describe::system_record& record;
  std::string_view name;
  manifold_factory create_manifold; ///< null if there are neither constraints nor quaternions
};

/// The interface of a system in a simulation: its survey, and functions over plain arrays in the order of its
/// vectors. Implementations add its parameters and options. Code that uses only this interface does not
/// depend on the model and is compiled without it.
class system_interface {
public:
  explicit system_interface(const system_description& of)
      : known(of.known), record(of.record), name(of.name), create_manifold(of.create_manifold) {}
  virtual ~system_interface() = default;

  const derivation::survey& known;
  const describe::system_record& record;
  const std::string_view name;
  const manifold_factory create_manifold; ///< see `system_description`

  int states() const { return known.coordinates + known.speeds; }

  /// Evaluates results at an instant, each in column-major order. Results that the method or the system does
  /// not need remain unchanged.
  virtual status evaluate(results wanted, const instant<double>& at, outputs<double> into) const = 0;
  virtual status evaluate(results wanted, const instant<std::complex<double>>& at,
                          outputs<std::complex<double>> into) const = 0;

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

/// Thrown when a user function uses a name that the model does not have. It ends the simulation, not the
/// program.
class unknown_name_error : public std::exception {
public:
  explicit unknown_name_error(const base::sentence& why) : why_(why) {}
  const char* what() const noexcept override { return why_.letters; }

private:
  base::sentence why_;
};

} // namespace kanexpr::simulations
