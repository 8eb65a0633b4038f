#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/second_order.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/linearized_step.hpp>

#include <Eigen/Core>

#include <type_traits>

namespace kanexpr {

namespace steps {

using compiled::survey_of;

/// The building blocks of the second derivatives of a step: the derivatives of the rates at a stage, in the
/// scalar type of the call.
template <class System>
struct weighted_rates {
  using quantity = mechanics::quantity;
  using of_second_order = kanexpr::second_order<System>;
  static constexpr int coordinates = survey_of<System>.coordinates, speeds = survey_of<System>.speeds,
                       inputs = survey_of<System>.inputs, states = coordinates + speeds,
                       size = of_second_order::size;

  template <class Number>
  using weights = typename of_second_order::template weights<Number>;
  template <class Number>
  using direction = typename of_second_order::template direction<Number>;
  template <class Number>
  using square = Eigen::Matrix<Number, size, size>;

  using gradient = function<System, quantity::weighted_gradient>;
  using hessian = function<System, quantity::weighted_hessian>;
  using gradient_and_product =
      function<System, quantity::weighted_gradient, quantity::weighted_hessian_product>;
  using rates_along = function<System, quantity::rhs, quantity::directional_derivative>;

  /// Whether the derivatives of q̇ are constant, so that q̇ has no second derivatives.
  static constexpr bool has_linear_kinematics = [] {
    using by = derivation::with_respect_to;
    using kinematics = function<System, derivation::derivatives_of_result{quantity::qdot, by::state},
                                derivation::derivatives_of_result{quantity::qdot, by::inputs}>;
    return kinematics::code::tape.sizes.loads == 0;
  }();
};

/// Concatenates two vectors.
template <class Above, class Below>
auto stacked(const Above& above, const Below& below) {
  Eigen::Matrix<typename Above::Scalar, Above::RowsAtCompileTime + Below::RowsAtCompileTime, 1> all;
  all << above, below;
  return all;
}

/// Runs the adjoint sweep backward through the stages of an explicit method. Each stage adds its Hessian,
/// weighted by its adjoint and transformed to the start of the step.
template <class Step>
struct step_of_second_order {
  using System = typename Step::system;
  using rates = weighted_rates<System>;
  static constexpr int states = rates::states, inputs = rates::inputs, size = rates::size;
  static constexpr int stages = Step::tableau.stages;

  /// Returns, for each stage, its time offset and the weight of its rate in the result, both multiplied by h.
  template <class Number>
  static constexpr void lengths(const Number& h, Number (&reach)[stages], Number (&weight)[stages]) {
    constexpr const auto& k = coefficients_of<Step::tableau, Number>;
    for (int s = 0; s < stages; ++s)
      reach[s] = Number(Number(k.a[s]) * h), weight[s] = Number(Number(k.b[s]) * h);
  }

  template <class Number, class Parameters, class Inputs, class Weights>
  static with_status<typename rates::template square<Number>>
  hessian(const Number& t, const state<System, Number>& x, const Number& h, const Parameters& p,
          const Inputs& r, const Weights& w) {
    using linear = rates_with_derivatives<System>;
    using derivatives = typename varied_state<System, Number>::derivatives;
    with_status<typename rates::template square<Number>> all;
    Number reach[stages], weight[stages];
    lengths(h, reach, weight);
    const varied_state<System, Number> before(x);
    varied_state<System, Number> at[stages];
    at[0] = before;
    Eigen::Matrix<Number, states, states> by_state[stages];
    for (int s = 0; s < stages; ++s) {
      const auto [rate, by_x, by_r] = typename linear::evaluated{}(Number(t + reach[s]), at[s].x, p, r);
      all.status = status_of(rate);
      if (!all.status) return all;
      by_state[s] = by_x;
      if (s + 1 == stages) break;
      derivatives by_all = linear::by_state::product(by_x, at[s].by_all);
      by_all.template rightCols<inputs>() += by_r;
      steps::advance(at[s + 1].x, 0, x, reach[s + 1], rate);
      at[s + 1].by_all = before.by_all + reach[s + 1] * by_all;
    }
    all.setZero();
    typename rates::template weights<Number> after =
        rates::template weights<Number>::Zero(); // the adjoint of a stage
    for (int s = stages; s-- > 0;) {
      typename rates::template weights<Number> of_rate = weight[s] * w;
      if (s + 1 < stages) of_rate += reach[s + 1] * after;
      const auto bent = typename rates::hessian{}(Number(t + reach[s]), at[s].x, p, r, of_rate);
      all.status = status_of(bent);
      if (!all.status) return all;
      add_seen_from_start(all, bent, at[s].by_all);
      after = by_state[s].transpose().lazyProduct(of_rate);
    }
    return all;
  }

  template <class Number, class Parameters, class Inputs, class Weights, class Direction>
  static with_status<typename rates::template direction<Number>>
  product(const Number& t, const state<System, Number>& x, const Number& h, const Parameters& p,
          const Inputs& r, const Weights& w, const Direction& v) {
    using weights = typename rates::template weights<Number>;
    using direction = typename rates::template direction<Number>;
    with_status<direction> all;
    Number reach[stages], weight[stages];
    lengths(h, reach, weight);
    state<System, Number> at[stages];
    direction along[stages];
    at[0] = x;
    for (direction& each : along) each = v;
    for (int s = 0; s + 1 < stages; ++s) {
      const auto [rate, change] = typename rates::rates_along{}(Number(t + reach[s]), at[s], p, r, along[s]);
      all.status = status_of(rate);
      if (!all.status) return all;
      steps::advance(at[s + 1], 0, x, reach[s + 1], rate);
      steps::advance(along[s + 1], 0, v, reach[s + 1], change);
    }
    all.setZero();
    weights after = weights::Zero(), change_after = weights::Zero();
    for (int s = stages; s-- > 0;) {
      weights of_rate = weight[s] * w, change_of_rate = weights::Zero();
      if (s + 1 < stages) of_rate += reach[s + 1] * after, change_of_rate = reach[s + 1] * change_after;
      const Number when = Number(t + reach[s]);
      const auto [slope, bent] = typename rates::gradient_and_product{}(when, at[s], p, r, of_rate, along[s]);
      all.status = status_of(slope);
      if (!all.status) return all;
      direction change = bent;
      if (s + 1 < stages) change += typename rates::gradient{}(when, at[s], p, r, change_of_rate);
      after = slope.template head<states>();
      change_after = change.template head<states>();
      all += change;
    }
    return all;
  }

private:
  /// Adds Zᵀ H Z of a stage with Z = [∂x/∂(x, r); 0 E].
  template <class Number, class Bent>
  static void add_seen_from_start(typename rates::template square<Number>& all, const Bent& bent,
                                  const typename varied_state<System, Number>::derivatives& by_all) {
    typename rates::template square<Number> right = bent.template leftCols<states>().lazyProduct(by_all);
    right.template rightCols<inputs>() += bent.template rightCols<inputs>();
    all += by_all.transpose().lazyProduct(right.template topRows<states>());
    all.template bottomRows<inputs>() += right.template bottomRows<inputs>();
  }
};

/// q⁺ = q + h q̇(q, u⁺, r) after u⁺ = u + h u̇(q, u, r).
template <class System>
struct step_of_second_order<kanexpr::semi_implicit_euler<System, 0>> {
  using rates = weighted_rates<System>;
  using quantity = mechanics::quantity;
  using by = derivation::with_respect_to;
  static constexpr int n = rates::coordinates, speeds = rates::speeds, states = rates::states,
                       inputs = rates::inputs, size = rates::size;
  using kinematics = function<System, derivation::derivatives_of_result{quantity::qdot, by::state}>;

  template <class Number, class Parameters, class Inputs, class Weights>
  static with_status<typename rates::template square<Number>>
  hessian(const Number& t, const state<System, Number>& x, const Number& h, const Parameters& p,
          const Inputs& r, const Weights& w) {
    using linear = rates_with_derivatives<System>;
    with_status<typename rates::template square<Number>> all;
    const auto [rate, by_x, by_r] = typename linear::evaluated{}(t, x, p, r);
    all.status = status_of(rate);
    if (!all.status) return all;
    state<System, Number> moving = x;
    steps::advance(moving, n, x, h, rate.template tail<speeds>());
    const auto of_speeds = weights_of_speeds(t, moving, h, p, r, w);
    all.status = of_speeds.status;
    if (!all.status) return all;
    const typename rates::template weights<Number> first =
        stacked(Eigen::Matrix<Number, n, 1>::Zero().eval(), (h * of_speeds).eval());
    const auto bent = typename rates::hessian{}(t, x, p, r, first);
    all.status = status_of(bent);
    if (!all.status) return all;
    static_cast<typename rates::template square<Number>&>(all) = bent;
    if constexpr (!rates::has_linear_kinematics) {
      typename rates::template square<Number> seen =
          rates::template square<Number>::Identity(); // ∂(q, u⁺, r)
      seen.template block<speeds, states>(n, 0) += h * by_x.template bottomRows<speeds>();
      seen.template block<speeds, inputs>(n, states) += h * by_r.template bottomRows<speeds>();
      const auto turned = typename rates::hessian{}(t, moving, p, r, weights_of_coordinates<Number>(h, w));
      all.status = status_of(turned);
      if (!all.status) return all;
      const typename rates::template square<Number> right = turned.lazyProduct(seen);
      all += seen.transpose().lazyProduct(right);
    }
    return all;
  }

  template <class Number, class Parameters, class Inputs, class Weights, class Direction>
  static with_status<typename rates::template direction<Number>>
  product(const Number& t, const state<System, Number>& x, const Number& h, const Parameters& p,
          const Inputs& r, const Weights& w, const Direction& v) {
    using direction = typename rates::template direction<Number>;
    with_status<direction> all;
    const auto [rate, change] = typename rates::rates_along{}(t, x, p, r, v);
    all.status = status_of(rate);
    if (!all.status) return all;
    state<System, Number> moving = x;
    steps::advance(moving, n, x, h, rate.template tail<speeds>());
    const auto of_speeds = weights_of_speeds(t, moving, h, p, r, w);
    all.status = of_speeds.status;
    if (!all.status) return all;
    direction turned = direction::Zero();
    if constexpr (!rates::has_linear_kinematics) {
      direction along = v;
      steps::advance(along, n, v, h, change.template tail<speeds>());
      const auto found =
          second_order<System>::hessian_product(t, moving, p, r, weights_of_coordinates<Number>(h, w), along);
      all.status = status_of(found);
      if (!all.status) return all;
      turned = found;
    }
    const auto first = [&](const auto& of) -> typename rates::template weights<Number> {
      return stacked(Eigen::Matrix<Number, n, 1>::Zero().eval(), (h * of).eval());
    };
    const auto bent = second_order<System>::hessian_product(t, x, p, r, first(of_speeds), v);
    all.status = status_of(bent);
    if (!all.status) return all;
    static_cast<direction&>(all) = turned + bent;
    if constexpr (!rates::has_linear_kinematics)
      all += typename rates::gradient{}(t, x, p, r, first(turned.template segment<speeds>(n)));
    return all;
  }

private:
  /// Returns the weights h λ_q of q̇.
  template <class Number, class Weights>
  static typename rates::template weights<Number> weights_of_coordinates(const Number& h, const Weights& w) {
    return stacked((h * w.template head<n>()).eval(), Eigen::Matrix<Number, speeds, 1>::Zero().eval());
  }

  /// Returns the weights λ_u + h (∂q̇/∂u)ᵀ λ_q of u⁺.
  template <class Number, class Parameters, class Inputs, class Weights>
  static with_status<Eigen::Matrix<Number, speeds, 1>>
  weights_of_speeds(const Number& t, const state<System, Number>& at, const Number& h, const Parameters& p,
                    const Inputs& r, const Weights& w) {
    const auto by_state = kinematics{}(t, at, p, r);
    const Eigen::Matrix<Number, n, 1> scaled = h * w.template head<n>();
    Eigen::Matrix<Number, speeds, 1> of = w.template tail<speeds>();
    of += by_state.template rightCols<speeds>().transpose().lazyProduct(scaled);
    return {of, status_of(by_state)};
  }
};

} // namespace steps

/// The second derivatives of λᵀx⁺, where x⁺ is the state after a fixed-length step, with respect to z = [x;
/// r]. The inputs are constant during the step.
///
///     const auto H = second_order_step<runge_kutta_4<System, 0>>::hessian(t, x, h, p, r, w);
///
/// They are exact for the discrete step and follow from those of the rates by the chain rule through its
/// stages (Griewank & Walther, Evaluating Derivatives, 2008, section 3.4). Steps with corrections are not
/// supported. The state may be constrained, but a system with quaternions is not supported, because their
/// norm differs from 1 within a step.
template <class Step>
struct second_order_step;

template <template <class, int> class Method, class System, int corrections>
struct second_order_step<Method<System, corrections>> {
  using quantity = mechanics::quantity;
  static_assert(corrections == 0, "second_order_step requires a step without corrections, such as "
                                  "runge_kutta_4<System, 0>");
  static_assert(compiled::survey_of<System>.quaternions == 0,
                "second_order_step requires a system without quaternions, because they have norm 1 only at "
                "the ends of a step");
  using step = steps::step_of_second_order<Method<System, 0>>;

  /// Returns ∂²(λᵀx⁺)/∂z², which is symmetric.
  template <class Number, class Parameters, class Inputs, class Weights>
  static auto hessian(std::type_identity_t<Number> t, const state<System, Number>& x,
                      std::type_identity_t<Number> h, const Parameters& p, const Inputs& r,
                      const Weights& w) {
    auto found = step::hessian(t, x, h, p, r, w);
    for (int i = 0; i < found.rows(); ++i)
      for (int j = 0; j < i; ++j) found(j, i) = found(i, j); // equal up to rounding
    return concluded(found, t, x, h, p, r);
  }

  /// Returns ∂²(λᵀx⁺)/∂z² v without forming the matrix.
  template <class Number, class Parameters, class Inputs, class Weights, class Direction>
  static auto hessian_product(std::type_identity_t<Number> t, const state<System, Number>& x,
                              std::type_identity_t<Number> h, const Parameters& p, const Inputs& r,
                              const Weights& w, const Direction& v) {
    return concluded(step::product(t, x, h, p, r, w, v), t, x, h, p, r);
  }

private:
  template <class Result, class Number, class Parameters, class Inputs>
  static Result concluded(Result found, const Number& t, const state<System, Number>& x, const Number& h,
                          const Parameters& p, const Inputs& r) {
    using math = lower::scalar_math<Number>;
    for (int i = 0; found.status && i < found.size(); ++i)
      if (!math::is_finite(found.coeff(i))) found.status = status(steps::step_not_finite);
    if constexpr (compiled::survey_of<System>.constraints != 0)
      if (found.status) { // a rejected step has no derivatives
        Number now = t;
        state<System, Number> next = x;
        found.status = Method<System, 0>{}(now, next, h, p, r);
      }
    if (!found.status) found.status = compiled::not_finite<System>::cause_of(found.status, x, p, r);
    return found;
  }
};

} // namespace kanexpr
