#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/tableaux.hpp>

#include <string_view>

/// Fixed-step methods, independent of how the equations are evaluated: by the functions of a compiled system
/// or by generated code. The equations provide
///
///     get<quantity>(t, x)        a result with its status
///     held(t, x)                 the same equations with the inputs held at that instant
///     finite(value, cause)       a status: whether the value is finite
///     corrected(t, x)            returns x to the constraints
///     has_pivots()               whether the constraints are solved for speeds
///     same_side(before, after)   a status: whether the `pivot_margin` of every pivot is positive
///
/// and, if the state is corrected,
///
///     normalize(x)               normalizes the quaternions, or reports one whose norm is outside `near_one`
///     quaternions_are_bound()    whether a constraint is solved for a coordinate of a quaternion
///     velocities_are_linear()    whether all constraints on the speeds are linear in them
///     dependent(i)               the index in the state of the i-th dependent entry, coordinates first
///
/// In generated code, every status reports success, and the requested quantities are recorded.
namespace kanexpr::steps {

/// Two sentences, one of which is a suffix of the other, so that a controller stores only one.
inline constexpr std::string_view state_not_finite = "the state after the step is not finite",
                                  step_not_finite = state_not_finite.substr(16);

/// The messages for steps in C++ and for steps in languages that have no `passing`.
inline constexpr std::string_view
    singular_position =
        "the step passes through or comes close to a position where the constraints cannot be solved for "
        "the dependent speeds: use passing<...>, or a different dependent<...> if only this choice is "
        "singular",
    singular_position_elsewhere =
        "the step passes through or comes close to a position where the constraints cannot be solved for "
        "the dependent speeds: use a model with a different dependent<...> if only this choice is singular";

/// Returns a positive number if a pivot of the constraints keeps its sign and changes by a factor below four.
/// A pivot that only touches zero, as a square does, keeps its sign but changes by a factor of at least 3 +
/// 2√2 = 5.83, either in the step that contains the zero or in the preceding one.
template <class Number>
[[gnu::always_inline]] inline Number pivot_margin(const Number& before, const Number& after) {
  const Number most = lower::scalar_math<Number>::from(4);
  return Number(Number(Number(most * before) - after) * Number(Number(most * after) - before));
}

/// A single step cannot bring a norm outside this range.
inline constexpr lower::norm_range near_one{0.5, 2};

/// Sets the entries of `to` from index `first` on to the entries of x + h ẋ.
template <class State, class Rate>
[[gnu::always_inline]] inline void advance(State& to, int first, const State& x,
                                           const typename State::Scalar& h, const Rate& rate) {
  using Number = typename State::Scalar;
  for (int i = 0; i < static_cast<int>(rate.size()); ++i)
    to(first + i) = Number(x(first + i) + Number(h * rate(i)));
}

/// Takes Newton steps for the dependent coordinates, then solves for the dependent speeds: by as many Newton
/// steps if constraints are not linear in the speeds.
template <class Equations, class Time, class State>
[[gnu::always_inline]] inline status correct(const Equations& of, int newton_steps, const Time& t, State& x) {
  using Number = typename State::Scalar;
  using mechanics::quantity;
  if (const status s = of.normalize(x); !s) return s;
  int first = 0;
  for (int done = 0; done < newton_steps; ++done) {
    const auto change = of.template get<quantity::configuration_step>(t, x);
    if (const status s = status_of(change); !s) return s;
    first = static_cast<int>(change.size());
    for (int i = 0; i < first; ++i) x(of.dependent(i)) = Number(x(of.dependent(i)) + change(i));
    if (of.quaternions_are_bound())
      if (const status s = of.normalize(x); !s) return s;
  }
  const int solutions = of.velocities_are_linear() ? 1 : newton_steps;
  status s;
  for (int done = 0; done < solutions && s; ++done) {
    const auto u = of.template get<quantity::dependent_speeds>(t, x);
    for (int i = 0; i < static_cast<int>(u.size()); ++i) x(of.dependent(first + i)) = u(i);
    s = status_of(u);
  }
  return s;
}

/// Advances a state by one step of a method, without corrections.
template <const tableau& of>
struct method {
  template <class Equations, class Time, class State>
  [[gnu::always_inline]] static status advance(const Equations& equations, const Time& t, const State& x,
                                               const Time& h, State& next) {
    using math = lower::scalar_math<typename State::Scalar>;
    constexpr const auto& k = coefficients_of<of, Time>;
    State at = x;
    Time reach = Time(0) * h;
    for (int stage = 0; stage < of.stages; ++stage) {
      const auto rate = equations.template get<mechanics::quantity::rhs>(static_cast<Time>(t + reach), at);
      if (const status s = status_of(rate); !s) return s;
      reach = Time(k.a[stage + 1]) * h;
      steps::advance(at, 0, x, math::from(reach), rate);
      steps::advance(next, 0, next, math::from(Time(k.b[stage]) * h), rate);
    }
    return {};
  }
};

/// u ← u + h u̇(t, q, u), then q ← q + h q̇(t, q, u) with the new speeds.
template <>
struct method<semi_implicit_euler> {
  template <class Equations, class Time, class State>
  [[gnu::always_inline]] static status advance(const Equations& of, const Time& t, const State& x,
                                               const Time& h, State& next) {
    using mechanics::quantity;
    const typename State::Scalar length = lower::scalar_math<typename State::Scalar>::from(h);
    const auto& held = of.held(t, x);
    const auto udot = held.template get<quantity::udot>(t, x);
    if (const status s = status_of(udot); !s) return s;
    const int coordinates = static_cast<int>(x.size()) - static_cast<int>(udot.size());
    steps::advance(next, coordinates, x, length, udot);
    const auto qdot = held.template get<quantity::qdot>(t, next); // at the coordinates before the step
    if (const status s = status_of(qdot); !s) return s;
    steps::advance(next, 0, x, length, qdot);
    return {};
  }
};

/// Rejects a step across a singular position, after which the motion could continue in any direction.
template <class Equations, class Time, class State>
[[gnu::always_inline]] inline status same_side(const Equations& of, const Time& t, const State& x,
                                               const Time& after, const State& next) {
  using mechanics::quantity;
  const auto before = of.template get<quantity::constraint_pivots>(t, x);
  const auto later = of.template get<quantity::constraint_pivots>(after, next);
  if (const status s = status_of(before); !s) return s;
  if (const status s = status_of(later); !s) return s;
  for (int i = 0; i < static_cast<int>(before.size()); ++i)
    if (const status s = of.same_side(before(i), later(i)); !s) return s;
  return {};
}

/// Advances x by one step; on failure, x is unchanged.
template <class Method, class Equations, class Time, class State>
[[gnu::always_inline]] inline status stepped(const Equations& of, const Time& t, State& x, const Time& h) {
  const Time after = static_cast<Time>(t + h);
  if (const status s = of.finite(after, step_not_finite); !s) return s;
  State next = x;
  if (const status s = Method::advance(of, t, x, h, next); !s) return s;
  if (const status s = of.corrected(after, next); !s) return s;
  for (int i = 0; i < static_cast<int>(next.size()); ++i)
    if (const status s = of.finite(next(i), state_not_finite); !s) return s;
  if (of.has_pivots())
    if (const status s = same_side(of, t, x, after, next); !s) return s;
  x = next;
  return {};
}

} // namespace kanexpr::steps
