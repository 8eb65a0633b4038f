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
  constexpr int rows = int{Above::RowsAtCompileTime} + int{Below::RowsAtCompileTime};
  Eigen::Matrix<typename Above::Scalar, rows, 1> all;
  all << above, below;
  return all;
}

/// The arguments of a step and the types of its second derivatives.
template <class Step, class Number, class Parameters, class Inputs>
struct step_at {
  using System = typename Step::system;
  using rates = weighted_rates<System>;
  using linear = rates_with_derivatives<System>;
  using weights = typename rates::template weights<Number>;
  using direction = typename rates::template direction<Number>;
  using square = typename rates::template square<Number>;
  static constexpr int states = rates::states, inputs = rates::inputs;

  const Number& t;
  const state<System, Number>& x;
  const Number& h;
  const Parameters& p;
  const Inputs& r;
};

/// Runs the adjoint sweep backward through the stages of an explicit method. Each stage adds its Hessian,
/// weighted by its adjoint and transformed to the start of the step.
template <class Step, class Number, class Parameters, class Inputs>
struct step_of_second_order : step_at<Step, Number, Parameters, Inputs> {
  using base = step_at<Step, Number, Parameters, Inputs>;
  using base::states, base::inputs, base::t, base::x, base::h, base::p, base::r;
  using typename base::direction, typename base::linear, typename base::rates, typename base::square,
      typename base::System, typename base::weights;
  static constexpr int stages = Step::tableau.stages;
  static constexpr const auto& k = coefficients_of<Step::tableau, Number>;

  template <class Weights>
  status hessian(const Weights& w, square& all) const {
    const varied_state<System, Number> before(x);
    varied_state<System, Number> at[stages];
    at[0] = before;
    Eigen::Matrix<Number, states, states> by_state[stages];
    for (int s = 0; s < stages; ++s) {
      const auto [rate, by_x, by_r] = typename linear::evaluated{}(time(s), at[s].x, p, r);
      if (const status found = status_of(rate); !found) return found;
      by_state[s] = by_x;
      if (s + 1 == stages) break;
      auto by_all = linear::by_state::product(by_x, at[s].by_all);
      by_all.template rightCols<inputs>() += by_r;
      steps::advance(at[s + 1].x, 0, x, reach(s + 1), rate);
      at[s + 1].by_all = before.by_all + reach(s + 1) * by_all;
    }
    all.setZero();
    weights after = weights::Zero(); // the adjoint of a stage
    for (int s = stages; s-- > 0;) {
      weights of_rate = weight(s) * w;
      if (s + 1 < stages) of_rate += reach(s + 1) * after;
      const auto curvature = typename rates::hessian{}(time(s), at[s].x, p, r, of_rate);
      if (const status found = status_of(curvature); !found) return found;
      add_transformed(all, curvature, at[s].by_all);
      after = by_state[s].transpose().lazyProduct(of_rate);
    }
    return {};
  }

  template <class Weights, class Direction>
  status product(const Weights& w, const Direction& v, direction& all) const {
    state<System, Number> at[stages];
    direction along[stages];
    at[0] = x;
    for (direction& each : along) each = v;
    for (int s = 0; s + 1 < stages; ++s) {
      const auto [rate, change] = typename rates::rates_along{}(time(s), at[s], p, r, along[s]);
      if (const status found = status_of(rate); !found) return found;
      steps::advance(at[s + 1], 0, x, reach(s + 1), rate);
      steps::advance(along[s + 1], 0, v, reach(s + 1), change);
    }
    all.setZero();
    weights after = weights::Zero(), change_after = weights::Zero();
    for (int s = stages; s-- > 0;) {
      weights of_rate = weight(s) * w, change_of_rate = weights::Zero();
      if (s + 1 < stages) of_rate += reach(s + 1) * after, change_of_rate = reach(s + 1) * change_after;
      const auto [slope, curvature] =
          typename rates::gradient_and_product{}(time(s), at[s], p, r, of_rate, along[s]);
      if (const status found = status_of(slope); !found) return found;
      direction change = curvature;
      if (s + 1 < stages) change += typename rates::gradient{}(time(s), at[s], p, r, change_of_rate);
      after = slope.template head<states>();
      change_after = change.template head<states>();
      all += change;
    }
    return {};
  }

private:
  Number reach(int s) const { return Number(Number(k.a[s]) * h); }
  Number time(int s) const { return Number(t + reach(s)); }
  Number weight(int s) const { return Number(Number(k.b[s]) * h); }

  /// Adds Zᵀ H Z of a stage with Z = [∂x/∂(x, r); 0 E].
  template <class Bent>
  static void add_transformed(square& all, const Bent& curvature,
                              const typename varied_state<System, Number>::derivatives& by_all) {
    square right = curvature.template leftCols<states>().lazyProduct(by_all);
    right.template rightCols<inputs>() += curvature.template rightCols<inputs>();
    all += by_all.transpose().lazyProduct(right.template topRows<states>());
    all.template bottomRows<inputs>() += right.template bottomRows<inputs>();
  }
};

/// q⁺ = q + h q̇(q, u⁺, r) after u⁺ = u + h u̇(q, u, r).
template <class Of, class Number, class Parameters, class Inputs>
struct step_of_second_order<kanexpr::semi_implicit_euler<Of, 0>, Number, Parameters, Inputs>
    : step_at<kanexpr::semi_implicit_euler<Of, 0>, Number, Parameters, Inputs> {
  using base = step_at<kanexpr::semi_implicit_euler<Of, 0>, Number, Parameters, Inputs>;
  using base::states, base::inputs, base::t, base::x, base::h, base::p, base::r;
  using typename base::direction, typename base::linear, typename base::rates, typename base::square,
      typename base::System, typename base::weights;
  static constexpr int n = rates::coordinates, speeds = rates::speeds;
  using coordinate_vector = Eigen::Matrix<Number, n, 1>;
  using speed_vector = Eigen::Matrix<Number, speeds, 1>;

  template <class Weights>
  status hessian(const Weights& w, square& all) const {
    const auto [rate, by_x, by_r] = typename linear::evaluated{}(t, x, p, r);
    if (const status found = status_of(rate); !found) return found;
    state<System, Number> moving = x;
    steps::advance(moving, n, x, h, rate.template tail<speeds>());
    const auto of_speeds = weights_of_speeds(moving, w);
    if (!of_speeds.status) return of_speeds.status;
    const auto curvature = typename rates::hessian{}(t, x, p, r, weights_of_rates(of_speeds));
    if (const status found = status_of(curvature); !found) return found;
    all = curvature;
    if constexpr (!rates::has_linear_kinematics) {
      square by_start = square::Identity(); // ∂(q, u⁺, r)
      by_start.template block<speeds, states>(n, 0) += h * by_x.template bottomRows<speeds>();
      by_start.template block<speeds, inputs>(n, states) += h * by_r.template bottomRows<speeds>();
      const auto of_coordinates = typename rates::hessian{}(t, moving, p, r, weights_of_coordinates(w));
      if (const status found = status_of(of_coordinates); !found) return found;
      const square right = of_coordinates.lazyProduct(by_start);
      all += by_start.transpose().lazyProduct(right);
    }
    return {};
  }

  template <class Weights, class Direction>
  status product(const Weights& w, const Direction& v, direction& all) const {
    const auto [rate, change] = typename rates::rates_along{}(t, x, p, r, v);
    if (const status found = status_of(rate); !found) return found;
    state<System, Number> moving = x;
    steps::advance(moving, n, x, h, rate.template tail<speeds>());
    const auto of_speeds = weights_of_speeds(moving, w);
    if (!of_speeds.status) return of_speeds.status;
    direction of_coordinates = direction::Zero();
    if constexpr (!rates::has_linear_kinematics) {
      direction along = v;
      steps::advance(along, n, v, h, change.template tail<speeds>());
      const auto found =
          second_order<System>::hessian_product(t, moving, p, r, weights_of_coordinates(w), along);
      if (!status_of(found)) return status_of(found);
      of_coordinates = found;
    }
    const auto curvature = second_order<System>::hessian_product(t, x, p, r, weights_of_rates(of_speeds), v);
    if (const status found = status_of(curvature); !found) return found;
    all = of_coordinates + curvature;
    if constexpr (!rates::has_linear_kinematics)
      all += typename rates::gradient{}(t, x, p, r,
                                        weights_of_rates(of_coordinates.template segment<speeds>(n)));
    return {};
  }

private:
  /// Returns the weights h λ_u of u̇.
  template <class Weights>
  weights weights_of_rates(const Weights& of_speeds) const {
    return stacked(coordinate_vector::Zero().eval(), (h * of_speeds).eval());
  }
  /// Returns the weights h λ_q of q̇.
  template <class Weights>
  weights weights_of_coordinates(const Weights& w) const {
    return stacked((h * w.template head<n>()).eval(), speed_vector::Zero().eval());
  }

  /// Returns the weights λ_u + h (∂q̇/∂u)ᵀ λ_q of u⁺.
  template <class Weights>
  with_status<speed_vector> weights_of_speeds(const state<System, Number>& at, const Weights& w) const {
    using derivation::with_respect_to, mechanics::quantity;
    const auto by_state =
        function<System, derivation::derivatives_of_result{quantity::qdot, with_respect_to::state}>{}(t, at,
                                                                                                      p, r);
    const coordinate_vector scaled = h * w.template head<n>();
    speed_vector of = w.template tail<speeds>();
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
  template <class Number, class Parameters, class Inputs>
  using step = steps::step_of_second_order<Method<System, 0>, Number, Parameters, Inputs>;

  /// Returns ∂²(λᵀx⁺)/∂z², which is symmetric.
  template <class Number, class Parameters, class Inputs, class Weights>
  static auto hessian(std::type_identity_t<Number> t, const state<System, Number>& x,
                      std::type_identity_t<Number> h, const Parameters& p, const Inputs& r,
                      const Weights& w) {
    with_status<typename step<Number, Parameters, Inputs>::square> found;
    found.status = step<Number, Parameters, Inputs>{{t, x, h, p, r}}.hessian(w, found);
    for (int i = 0; i < found.rows(); ++i)
      for (int j = 0; j < i; ++j) found(j, i) = found(i, j); // equal up to rounding
    return concluded(found, t, x, h, p, r);
  }

  /// Returns ∂²(λᵀx⁺)/∂z² v without forming the matrix.
  template <class Number, class Parameters, class Inputs, class Weights, class Direction>
  static auto hessian_product(std::type_identity_t<Number> t, const state<System, Number>& x,
                              std::type_identity_t<Number> h, const Parameters& p, const Inputs& r,
                              const Weights& w, const Direction& v) {
    with_status<typename step<Number, Parameters, Inputs>::direction> found;
    found.status = step<Number, Parameters, Inputs>{{t, x, h, p, r}}.product(w, v, found);
    return concluded(found, t, x, h, p, r);
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
