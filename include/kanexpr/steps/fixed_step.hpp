#pragma once

#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/steps/correction.hpp>

#include <type_traits>

/// Explicit integrators with a fixed step, for use in real time: the work of a step is known beforehand, no
/// memory is taken and nothing is thrown.
///
///     runge_kutta_4<System> step;
///     if (const status s = step(t, x, h, p, r); !s) …  // t and x are one step further
///
/// The inputs r are a vector, which holds during the step, or a function (t, x) that gives them, asked
/// wherever the equations are evaluated; quantities that are prescribed need the function. `corrections` is
/// how many steps of Newton's method bring the dependent coordinates back to the constraints, with the
/// dependent speeds after them; quaternions get norm 1 before them. 0 leaves all as it was integrated. Where
/// something cannot be solved, or the state would not be finite, the status says so, and t and x stay as they
/// were.
namespace kanexpr {

namespace compiled {

/// Two sentences of which the one ends like the other, so that a controller keeps one.
inline constexpr std::string_view state_not_finite = "the state after the step is not finite",
                                  step_not_finite = state_not_finite.substr(16);

/// Whether inputs are given as a vector, which holds during a step, or not at all; else by a function.
template <class R>
inline constexpr bool inputs_hold = requires { R::SizeAtCompileTime; } || std::is_same_v<R, not_given>;

/// The inputs at an instant, from a vector or a function.
template <class R, class Time, class X>
[[gnu::always_inline]] inline decltype(auto) inputs_at(const R& r, const Time& t, const X& x) {
  if constexpr (inputs_hold<R>)
    return (r);
  else
    return r(t, x);
}

/// Sets the entries of `to` from `first` on to those of x + h ẋ.
template <int first, int count, class X, class Rate>
[[gnu::always_inline]] inline void advance(X& to, const X& x, const typename X::Scalar& h, const Rate& rate) {
  using T = typename X::Scalar;
  for (int i = 0; i < count; ++i) to(first + i) = T(x(first + i) + T(h * rate(i)));
}

/// Ends a step: `next` is corrected and looked at, and becomes the state.
template <class System, int corrections, class Time, class T, class P, class R>
status conclude(Time& t, state<System, T>& x, const Time& after, state<System, T>& next, const P& p,
                const R& r) {
  using correct = correction<System, corrections>;
  if constexpr (correct::is_needed)
    if (const status s = correct::apply(after, next, p, inputs_at(r, after, next)); !s) return s;
  for (int i = 0; i < static_cast<int>(next.size()); ++i)
    if (!lower::scalar_math<T>::is_finite(next(i))) return status(state_not_finite);
  t = after;
  x = next;
  return {};
}

} // namespace compiled

/// Semi-implicit (symplectic) Euler: u ← u + h u̇(t, q, u), then q ← q + h q̇(t, q, u) with the new speeds
/// (Hairer, Lubich & Wanner, Geometric Numerical Integration, 2006, I.1.2). Of order 1; the energy of a
/// conservative system stays bounded.
template <class System, int corrections = 1>
struct semi_implicit_euler {
  using eom = equations_of_motion<System>;

  template <class Time, class T, class P = compiled::not_given, class R = compiled::not_given>
  status operator()(Time& t, state<System, T>& x, std::type_identity_t<Time> h, const P& p = {},
                    const R& r = {}) const {
    const status s = attempted(t, x, h, p, r);
    return s ? s : compiled::not_finite<System>::cause_of(s, x, p, compiled::inputs_at(r, t, x));
  }

  /// Operations of one step, beside the sums of the method itself.
  static constexpr symbolic::cost cost() {
    return compiled::added(compiled::added(eom::udot.cost(), eom::qdot.cost()),
                           compiled::correction<System, corrections>::cost());
  }

private:
  template <class Time, class T, class P, class R>
  static status attempted(Time& t, state<System, T>& x, Time h, const P& p, const R& r) {
    if (!lower::scalar_math<Time>::is_finite(Time(t + h))) return status(compiled::step_not_finite);
    const T length = lower::scalar_math<T>::from(h);
    const auto& given = compiled::inputs_at(r, t, x);
    state<System, T> next = x;
    const auto udot = eom::udot(t, x, p, given);
    if (const status s = compiled::status_of(udot); !s) return s;
    compiled::advance<eom::coordinates, eom::speeds>(next, x, length, udot);
    const auto qdot = eom::qdot(t, next, p, given); // at the coordinates before
    if (const status s = compiled::status_of(qdot); !s) return s;
    compiled::advance<0, eom::coordinates>(next, x, length, qdot);
    return compiled::conclude<System, corrections>(t, x, static_cast<Time>(t + h), next, p, r);
  }
};

/// The classic Runge-Kutta method, of order 4 (Hairer, Nørsett & Wanner, Solving Ordinary Differential
/// Equations I, 1993, II.1). It evaluates the equations at t, twice at t + h/2 and at t + h.
template <class System, int corrections = 1>
struct runge_kutta_4 {
  using eom = equations_of_motion<System>;
  static constexpr int stages = 4;

  template <class Time, class T, class P = compiled::not_given, class R = compiled::not_given>
  status operator()(Time& t, state<System, T>& x, std::type_identity_t<Time> h, const P& p = {},
                    const R& r = {}) const {
    const status s = attempted(t, x, h, p, r);
    return s ? s : compiled::not_finite<System>::cause_of(s, x, p, compiled::inputs_at(r, t, x));
  }

  /// Operations of one step, beside the sums of the method itself.
  static constexpr symbolic::cost cost() {
    return compiled::added(compiled::correction<System, corrections>::cost(), eom::rhs.cost(), stages);
  }

private:
  template <class Time, class T, class P, class R>
  static status attempted(Time& t, state<System, T>& x, Time h, const P& p, const R& r) {
    if (!lower::scalar_math<Time>::is_finite(Time(t + h))) return status(compiled::step_not_finite);
    constexpr int size = eom::coordinates + eom::speeds;
    constexpr Time half = Time(0.5), third = Time(1) / 3, sixth = Time(1) / 6;
    constexpr Time reach[stages + 1]{0, half, half, 1, 0}, weight[stages]{sixth, third, third, sixth};
    state<System, T> at = x, next = x;
    for (int stage = 0; stage < stages; ++stage) {
      const Time when = static_cast<Time>(t + reach[stage] * h);
      const auto rate = eom::rhs(when, at, p, compiled::inputs_at(r, when, at));
      if (const status s = compiled::status_of(rate); !s) return s;
      compiled::advance<0, size>(at, x, lower::scalar_math<T>::from(reach[stage + 1] * h), rate);
      compiled::advance<0, size>(next, next, lower::scalar_math<T>::from(weight[stage] * h), rate);
    }
    return compiled::conclude<System, corrections>(t, x, static_cast<Time>(t + h), next, p, r);
  }
};

} // namespace kanexpr
