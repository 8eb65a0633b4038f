#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/correction.hpp>

#include <string_view>
#include <type_traits>

/// Explicit fixed-step integrators for real-time use: the work per step is fixed, and a step neither
/// allocates nor throws.
///
///     runge_kutta_4<System> step;
///     if (const status s = step(t, x, h, p, r); !s) …  // t and x have advanced by one step
///
/// The inputs r are a vector, held constant during the step, or a function (t, x) that is called at every
/// evaluation of the equations; prescribed quantities require the function. `corrections` is the number of
/// Newton steps that return the dependent coordinates to the constraints; quaternions are normalized before
/// these steps, and the dependent speeds are solved for after them. With 0 corrections, the integrated state
/// is not corrected. If a system of equations cannot be solved, or the state would not be finite, the status
/// reports the cause, and t and x are unchanged. The same holds if a step would pass through or come close to
/// a position at which the constraints cannot be solved for the dependent speeds;
/// `passing<runge_kutta_4<System>>` continues through such positions.
namespace kanexpr {

namespace steps {

/// Whether the inputs are a vector, which is held constant during a step, or omitted, rather than a function.
template <class Inputs>
inline constexpr bool inputs_hold =
    requires { Inputs::SizeAtCompileTime; } || std::is_same_v<Inputs, compiled::omitted>;

/// Returns the inputs at an instant, from a vector or a function.
template <class Inputs, class Time, class State>
[[gnu::always_inline]] inline decltype(auto) inputs_at(const Inputs& r, const Time& t, const State& x) {
  if constexpr (inputs_hold<Inputs>)
    return (r);
  else
    return r(t, x);
}

/// The functions of a system with its parameters and inputs, in the form that the integration methods
/// require.
template <class System, int corrections, class Parameters, class Inputs>
struct compiled_equations {
  using correct = correction<System, corrections>;
  const Parameters& p;
  Inputs r; ///< a reference, or the inputs at an instant

  template <mechanics::quantity wanted, class Time, class State>
  [[gnu::always_inline]] auto get(const Time& t, const State& x) const {
    if constexpr (wanted == mechanics::quantity::constraint_pivots) // evaluated twice per step
      return out_of_line<function<System, wanted>>{}(t, x, p, inputs_at(r, t, x));
    else
      return function<System, wanted>{}(t, x, p, inputs_at(r, t, x));
  }
  template <class Time, class State>
  [[gnu::always_inline]] auto held(const Time& t, const State& x) const {
    return compiled_equations<System, corrections, Parameters, decltype(inputs_at(r, t, x))>{
        p, inputs_at(r, t, x)};
  }
  template <class Number>
  [[gnu::always_inline]] static status finite(const Number& value, std::string_view cause) {
    return lower::scalar_math<Number>::is_finite(value) ? status() : status(cause);
  }
  static constexpr bool has_pivots() { return compiled::survey_of<System>.constraints != 0; }
  template <class Number>
  [[gnu::always_inline]] status same_side(const Number& before, const Number& after) const {
    using math = lower::scalar_math<Number>;
    return math::exceeds(pivot_margin(before, after), math::from(0)) ? status() : status(singular_position);
  }
  template <class Time, class State>
  [[gnu::always_inline]] status corrected(const Time& t, State& x) const {
    if constexpr (correct::is_needed)
      return correct::apply(t, x, p, inputs_at(r, t, x));
    else
      return {};
  }
};

/// Returns the number of operations that the pivot checks before and after a step need.
template <class System>
constexpr symbolic::cost cost_of_sides() {
  if constexpr (compiled::survey_of<System>.constraints == 0)
    return {};
  else
    return added({}, function<System, mechanics::quantity::constraint_pivots>::cost(), 2);
}

/// Takes a step with a given method. On failure, t and x are unchanged, and the status may name an invalid
/// argument.
template <class Method, class System, int corrections, class Time, class Number, class Parameters,
          class Inputs>
[[gnu::always_inline]] inline status advanced(Time& t, state<System, Number>& x, const Time& h,
                                              const Parameters& p, const Inputs& r) {
  const status s =
      stepped<Method>(compiled_equations<System, corrections, Parameters, const Inputs&>{p, r}, t, x, h);
  if (!s) return compiled::not_finite<System>::cause_of(s, x, p, inputs_at(r, t, x));
  t = static_cast<Time>(t + h);
  return s;
}

/// A fixed-length step of a method.
template <const steps::tableau& of, class System, int steps_of_correction>
struct fixed_step {
  using system = System;
  using eom = equations_of_motion<System>;
  using method = steps::method<of>;
  static constexpr const steps::tableau& tableau = of;
  static constexpr int corrections = steps_of_correction, stages = of.stages;

  template <class Time, class Number, class Parameters = compiled::omitted, class Inputs = compiled::omitted>
  status operator()(Time& t, state<System, Number>& x, std::type_identity_t<Time> h, const Parameters& p = {},
                    const Inputs& r = {}) const {
    return advanced<method, System, corrections>(t, x, h, p, r);
  }

  /// Returns the number of operations of one step, excluding the sums of the method itself.
  static constexpr symbolic::cost cost() {
    const symbolic::cost ends = added(cost_of_sides<System>(), correction<System, corrections>::cost());
    if constexpr (&of == &steps::semi_implicit_euler)
      return added(added(eom::udot.cost(), eom::qdot.cost()), ends);
    else
      return added(ends, eom::rhs.cost(), stages);
  }
};

} // namespace steps

/// Semi-implicit (symplectic) Euler: u ← u + h u̇(t, q, u), then q ← q + h q̇(t, q, u) with the new speeds
/// (Hairer, Lubich & Wanner, Geometric Numerical Integration, 2006, I.1.2). It has order 1; the energy error
/// of a conservative system stays bounded.
template <class System, int corrections = 1>
struct semi_implicit_euler : steps::fixed_step<steps::semi_implicit_euler, System, corrections> {};

/// The classic fourth-order Runge-Kutta method (Hairer, Nørsett & Wanner, Solving Ordinary Differential
/// Equations I, 1993, II.1). It evaluates the equations at t, twice at t + h/2, and at t + h.
template <class System, int corrections = 1>
struct runge_kutta_4 : steps::fixed_step<steps::runge_kutta_4, System, corrections> {};

/// Ralston's third-order method, which has the smallest error bound among the three-stage methods (Ralston,
/// Mathematics of Computation 16, 1962). It evaluates the equations at t, t + h/2 and t + 3h/4, at three
/// quarters of the cost of `runge_kutta_4`.
template <class System, int corrections = 1>
struct ralston_3 : steps::fixed_step<steps::ralston_3, System, corrections> {};

} // namespace kanexpr
