#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/linearization.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/fixed_step.hpp>
#include <kanexpr/steps/known_entries.hpp>

#include <Eigen/Core>

#include <type_traits>

namespace kanexpr {

/// The state after a fixed-length step, with its derivatives with respect to the state before the step and to
/// the inputs, which are constant during the step: A_d and B_d of the discrete step.
template <class System, class Number>
struct linearized_state {
  static constexpr int size = equations_of_motion<System>::coordinates + equations_of_motion<System>::speeds;

  kanexpr::state<System, Number> state;
  Eigen::Matrix<Number, size, size> by_state;
  Eigen::Matrix<Number, size, compiled::survey_of<System>.inputs> by_inputs;
  kanexpr::status status{}; ///< if it reports a failure, the other members are meaningless
};

namespace steps {

using compiled::survey_of;

/// A state within a step and its derivatives with respect to the state before the step (left columns) and the
/// inputs (right columns).
template <class System, class Number>
struct varied_state {
  static constexpr int size = linearized_state<System, Number>::size, inputs = survey_of<System>.inputs;
  using derivatives = Eigen::Matrix<Number, size, size + inputs>;

  state<System, Number> x;
  derivatives by_all;

  varied_state() = default;
  explicit varied_state(const state<System, Number>& before) : x(before) {
    by_all.setZero();
    for (int i = 0; i < size; ++i) by_all(i, i) = lower::scalar_math<Number>::from(1);
  }
};

/// ẋ with its derivatives with respect to the state and the inputs. The general form of the equations needs
/// fewer operations for the derivatives than for ẋ itself, but it is valid only for quaternions of norm 1,
/// and within a step their norms differ from 1.
template <class System>
struct rates_with_derivatives {
  using quantity = mechanics::quantity;
  using by = derivation::with_respect_to;
  static constexpr int size = linearized_state<System, double>::size;
  static constexpr bool has_quaternions = survey_of<System>.quaternions > 0;
  using evaluated = std::conditional_t<
      has_quaternions,
      function<System, quantity::rhs, derivation::derivatives_of_result{quantity::rhs, by::state},
               derivation::derivatives_of_result{quantity::rhs, by::inputs}>,
      function<System, quantity::rhs, quantity::state_jacobian, quantity::input_jacobian>>;
  /// ẋ precedes the matrix.
  using by_state = known_entries<typename evaluated::code, size, size, size>;
};

/// Propagates derivatives through the correction at the end of a step.
template <class System, int corrections>
struct varied_correction {
  using quantity = mechanics::quantity;
  using by = derivation::with_respect_to;
  static constexpr const derivation::survey& known = survey_of<System>;
  using correct = correction<System, corrections>;
  template <quantity of>
  using varied = function<System, of, derivation::derivatives_of_result{of, by::state},
                          derivation::derivatives_of_result{of, by::inputs}>;

  template <class Time, class Number, class Parameters, class Inputs>
  static status apply(const Time& t, varied_state<System, Number>& next, const Parameters& p,
                      const Inputs& r) {
    if constexpr (!correct::is_needed) return {};
    if (const status s = normalize(next); !s) return s;
    if constexpr (known.configuration_constraints > 0)
      for (int done = 0; done < corrections; ++done) {
        const auto s = add<varied<quantity::configuration_step>>(t, next, 0, p, r, true);
        if (!s) return s;
        if constexpr (unit_quaternions<System>::are_bound)
          if (const status n = normalize(next); !n) return n;
      }
    if constexpr (known.constraints > 0)
      for (int done = 0; done < correct::solutions; ++done) {
        constexpr int first = known.configuration_constraints;
        if (const status s = add<varied<quantity::dependent_speeds>>(t, next, first, p, r, false); !s)
          return s;
      }
    return {};
  }

  /// Returns the number of operations of all evaluations, products and sums.
  static constexpr symbolic::cost cost() {
    symbolic::cost total;
    if constexpr (!correct::is_needed) return total;
    total = cost_of_norms();
    if constexpr (known.configuration_constraints > 0) {
      symbolic::cost one =
          cost_of_adding<varied<quantity::configuration_step>>(known.configuration_constraints, true);
      if constexpr (unit_quaternions<System>::are_bound) one = added(one, cost_of_norms());
      total = added(total, one, corrections);
    }
    if constexpr (known.constraints > 0)
      total = added(total, cost_of_adding<varied<quantity::dependent_speeds>>(known.constraints, false),
                    correct::solutions);
    return total;
  }

private:
  static constexpr int size = linearized_state<System, double>::size, inputs = known.inputs,
                       columns = size + inputs;

  template <class Function>
  static constexpr symbolic::cost cost_of_adding(int rows, bool accumulates) {
    const int sums = size - 1 + (accumulates ? 1 : 0);
    return added(Function::cost(),
                 arithmetic(rows * columns * size, rows * (columns * sums + inputs + (accumulates ? 1 : 0))));
  }

  static constexpr symbolic::cost cost_of_norms() {
    using quaternions = unit_quaternions<System>;
    symbolic::cost total = quaternions::cost();
    quaternions::each([&](int, const auto& places) {
      const int n = static_cast<int>(places.size());
      total = added(total, arithmetic(n + columns * (1 + 2 * n), n + columns * 2 * n, columns * n));
    });
    return total;
  }
  /// Adds a function of the state to the dependent entries from index `first` on, or assigns it to them.
  template <class Function, class Time, class Number, class Parameters, class Inputs>
  static status add(const Time& t, varied_state<System, Number>& next, int first, const Parameters& p,
                    const Inputs& r, bool accumulates) {
    using state_type = varied_state<System, Number>;
    const auto [change, by_state, by_inputs] = out_of_line<Function>{}(t, next.x, p, r);
    if (const status s = status_of(change); !s) return s;
    constexpr int rows = std::remove_cvref_t<decltype(by_state)>::RowsAtCompileTime;
    Eigen::Matrix<Number, rows, state_type::size + state_type::inputs> by_all =
        by_state.lazyProduct(next.by_all);
    by_all.template rightCols<state_type::inputs>() += by_inputs;
    for (int i = 0; i < rows; ++i) {
      const int to = correct::place(first + i);
      if (accumulates) {
        next.x(to) += change(i);
        next.by_all.row(to) += by_all.row(i);
      } else {
        next.x(to) = change(i);
        next.by_all.row(to) = by_all.row(i);
      }
    }
    return {};
  }

  /// Replaces each quaternion x by x/|x|, with the derivative (1 − x xᵀ/x²)/|x|.
  template <class Number>
  static status normalize(varied_state<System, Number>& next) {
    using quaternions = unit_quaternions<System>;
    if constexpr (quaternions::count == 0) return {};
    const state<System, Number> before = next.x;
    if (const status s = quaternions::normalize(next.x, near_one); !s) return s;
    quaternions::each([&](int, const auto& places) {
      Number along_square = lower::scalar_math<Number>::from(0);
      for (const int place : places)
        along_square = Number(along_square + Number(before(place) * next.x(place)));
      auto along = (next.by_all.row(0) * lower::scalar_math<Number>::from(0)).eval(); // the derivative of |x|
      for (const int place : places) along += next.x(place) * next.by_all.row(place);
      for (const int place : places)
        next.by_all.row(place) = ((next.by_all.row(place) - next.x(place) * along) / along_square).eval();
    });
    return {};
  }
};

/// Completes a step from x, as `stepped` does.
template <class System, int corrections, class Number, class Parameters, class Inputs>
linearized_state<System, Number> completed(const Number& t, const state<System, Number>& x, const Number& h,
                                           varied_state<System, Number>& next, const Parameters& p,
                                           const Inputs& r) {
  using result = linearized_state<System, Number>;
  const Number after = Number(t + h);
  status s = varied_correction<System, corrections>::apply(after, next, p, r);
  for (int i = 0; s && i < result::size; ++i)
    if (!lower::scalar_math<Number>::is_finite(next.x(i))) s = status(state_not_finite);
  if constexpr (survey_of<System>.constraints != 0)
    if (s) {
      const compiled_equations<System, corrections, Parameters, const Inputs&> of{p, r};
      s = steps::same_side(of, t, x, after, next.x);
    }
  return {next.x, next.by_all.template leftCols<result::size>(),
          next.by_all.template rightCols<varied_state<System, Number>::inputs>(), s};
}

/// Returns the number of operations that the pivot checks need, including the margins.
template <class System>
constexpr symbolic::cost cost_of_pivot_checks() {
  constexpr int pivots = survey_of<System>.constraints;
  return added(cost_of_sides<System>(), arithmetic(3 * pivots, 2 * pivots));
}

/// Returns the number of operations needed to add h times a vector of the given length.
constexpr symbolic::cost cost_of_advance(int entries) { return arithmetic(entries, entries); }

/// Applies the chain rule through the stages of an explicit method. The derivatives accumulated so far are
/// multiplied by the Jacobian of ẋ; entries known to be 0 or 1 need no multiplication.
template <class Step>
struct varied_step {
  using System = typename Step::system;
  static constexpr const steps::tableau& tableau = Step::tableau;
  static constexpr int corrections = Step::corrections, stages = tableau.stages;

  static constexpr symbolic::cost cost() {
    using rates = rates_with_derivatives<System>;
    constexpr int size = varied_state<System, double>::size, inputs = varied_state<System, double>::inputs,
                  all = size * (1 + size + inputs);
    const symbolic::cost chain = added(rates::by_state::cost(size + inputs), arithmetic(0, size * inputs)),
                         evaluations =
                             added(arithmetic(2 * stages - 1, stages + 1), rates::evaluated::cost(), stages);
    return added(added(added(evaluations, chain, stages - 1), cost_of_advance(all), stages - 1 + stages),
                 added(varied_correction<System, corrections>::cost(), cost_of_pivot_checks<System>()));
  }

  template <class Number, class Parameters, class Inputs>
  static linearized_state<System, Number> take(const Number& t, const state<System, Number>& x,
                                               const Number& h, const Parameters& p, const Inputs& r) {
    using rates = rates_with_derivatives<System>;
    using varied = varied_state<System, Number>;
    constexpr int inputs = varied::inputs;
    varied at(x), next(x);
    const varied before(x);
    constexpr const auto& k = coefficients_of<tableau, Number>;
    Number reach = Number(0);
    for (int stage = 0; stage < stages; ++stage) {
      const auto [rate, by_state, by_inputs] = typename rates::evaluated{}(Number(t + reach), at.x, p, r);
      if (const status s = status_of(rate); !s) return {x, {}, {}, s};
      typename varied::derivatives by_all;
      if (stage == 0) {
        by_all << by_state, by_inputs;
      } else {
        by_all = rates::by_state::product(by_state, at.by_all);
        by_all.template rightCols<inputs>() += by_inputs;
      }
      if (stage + 1 < stages) {
        reach = Number(Number(k.a[stage + 1]) * h);
        steps::advance(at.x, 0, x, reach, rate);
        at.by_all = before.by_all + reach * by_all;
      }
      const Number weight = Number(Number(k.b[stage]) * h);
      steps::advance(next.x, 0, next.x, weight, rate);
      next.by_all += weight * by_all;
    }
    return completed<System, corrections>(t, x, h, next, p, r);
  }
};

template <class System, int corrections>
struct varied_step<kanexpr::semi_implicit_euler<System, corrections>> {
  using eom = equations_of_motion<System>;
  using quantity = mechanics::quantity;
  using by = derivation::with_respect_to;
  template <quantity of>
  using varied = function<System, of, derivation::derivatives_of_result{of, by::state},
                          derivation::derivatives_of_result{of, by::inputs}>;
  static constexpr int n = eom::coordinates, speeds = eom::speeds, size = varied_state<System, double>::size,
                       inputs = varied_state<System, double>::inputs;

  static constexpr symbolic::cost cost() {
    const symbolic::cost of_speeds = added(varied<quantity::udot>::cost(),
                                           cost_of_advance(speeds * (1 + size + inputs))),
                         of_coordinates = added(varied<quantity::qdot>::cost(),
                                                cost_of_advance(n * (1 + size + inputs + inputs)));
    const symbolic::cost chain = arithmetic(n * (size + inputs) * size, n * (size + inputs) * (size - 1));
    return added(added(added(of_speeds, of_coordinates), added(chain, arithmetic(0, 1))),
                 added(varied_correction<System, corrections>::cost(), cost_of_pivot_checks<System>()));
  }

  template <class Number, class Parameters, class Inputs>
  static linearized_state<System, Number> take(const Number& t, const state<System, Number>& x,
                                               const Number& h, const Parameters& p, const Inputs& r) {
    using state_type = varied_state<System, Number>;
    state_type next(x);
    const auto [udot, u_by_state, u_by_inputs] = varied<quantity::udot>{}(t, x, p, r);
    if (const status s = status_of(udot); !s) return {x, {}, {}, s};
    steps::advance(next.x, n, x, h, udot);
    next.by_all.template bottomLeftCorner<speeds, size>() += h * u_by_state;
    next.by_all.template bottomRightCorner<speeds, inputs>() += h * u_by_inputs;
    const auto [qdot, q_by_state, q_by_inputs] = varied<quantity::qdot>{}(t, next.x, p, r);
    if (const status s = status_of(qdot); !s) return {x, {}, {}, s};
    steps::advance(next.x, 0, x, h, qdot);
    const typename state_type::derivatives here = next.by_all;
    next.by_all.template topRows<n>() += h * q_by_state.lazyProduct(here);
    next.by_all.template topRightCorner<n, inputs>() += h * q_by_inputs;
    return completed<System, corrections>(t, x, h, next, p, r);
  }
};

} // namespace steps

/// Returns the result of a fixed-length step with its derivatives, which are exact for the discrete step,
/// including corrections: `const auto next = linearized<runge_kutta_4<System>>{}(t, x, h, p, r);` The
/// arguments are left unchanged.
template <class Step>
struct linearized {
  template <class System, class Number, class Parameters = compiled::omitted,
            class Inputs = compiled::omitted>
  linearized_state<System, Number> operator()(std::type_identity_t<Number> t, const state<System, Number>& x,
                                              std::type_identity_t<Number> h, const Parameters& p = {},
                                              const Inputs& r = {}) const {
    constexpr bool inputs_hold = steps::inputs_hold<Inputs>;
    static_assert(inputs_hold, "linearized<Step> requires inputs that are constant during the step, because "
                               "it differentiates with respect to them; it does not accept a function");
    if constexpr (inputs_hold)
      return stepped(t, x, h, p, r);
    else
      return {x, {}, {}, {}};
  }

  /// Returns the number of operations of one step with its derivatives: the evaluations, the chain-rule
  /// products and the sums of the method itself.
  static constexpr symbolic::cost cost() {
    return steps::added(steps::varied_step<Step>::cost(), steps::arithmetic(0, 1)); // the check of t + h
  }

private:
  template <class System, class Number, class Parameters, class Inputs>
  static linearized_state<System, Number> stepped(const Number& t, const state<System, Number>& x,
                                                  const Number& h, const Parameters& p, const Inputs& r) {
    if (!lower::scalar_math<Number>::is_finite(Number(t + h)))
      return {x, {}, {}, status(steps::step_not_finite)};
    linearized_state<System, Number> next = steps::varied_step<Step>::take(t, x, h, p, r);
    if (!next.status) next.status = compiled::not_finite<System>::cause_of(next.status, x, p, r);
    return next;
  }
};

} // namespace kanexpr
