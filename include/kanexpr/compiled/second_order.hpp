#pragma once

#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/request_kinds.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <Eigen/Core>

namespace kanexpr {

/// Second-order derivatives of a weighted sum of the rates, λᵀẋ with ẋ = [q̇; u̇], as compiled functions for
/// optimal control. They are taken with respect to z = [q; u; r], the whole state and the inputs, as if the
/// state were unconstrained. λ, the argument w, contains a weight for each rate; with zeros for q̇, the sum
/// is λᵀu̇. A direction v is a change in z. No inverse is differentiated, and all derivatives are exact.
///
/// Quaternions must have norm 1; derivatives in the direction that changes the norm are meaningless.
template <class System>
struct second_order {
  using quantity = mechanics::quantity;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;

  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;

  /// The number of entries of z.
  static constexpr int size = known.coordinates + known.speeds + known.inputs;
  template <class Number = double>
  using weights = Eigen::Matrix<Number, known.coordinates + known.speeds, 1>;
  template <class Number = double>
  using direction = Eigen::Matrix<Number, size, 1>;

  /// ∂²(λᵀẋ)/∂z², symmetric: `second_order<System>::hessian(x, p, r, w)`.
  static constexpr function<System, quantity::weighted_hessian> hessian{};
  /// ∂²(λᵀẋ)/∂z² v, without forming the matrix: f(x, p, r, w, v).
  static constexpr function<System, quantity::weighted_hessian_product> hessian_product{};
  /// ∂(λᵀẋ)/∂z = (∂ẋ/∂z)ᵀ λ: f(x, p, r, w).
  static constexpr function<System, quantity::weighted_gradient> gradient{};
  /// (∂ẋ/∂z) v: f(x, p, r, v).
  static constexpr function<System, quantity::directional_derivative> directional_derivative{};

  /// Returns the number of operations of one call of a function.
  template <auto... wanted>
  static constexpr symbolic::cost cost(function<System, wanted...> f) {
    return f.cost();
  }
};

/// The derivatives of the rates ẋ = [q̇; u̇] with respect to parameters of the system, one column per
/// parameter: `sensitivity<System, m, l>(x, p, r)`. The rows of u̇ come last.
template <class System, auto... parameters>
inline constexpr function<System, derivation::sensitivity_to<parameters...>{}> sensitivity{};

} // namespace kanexpr
