#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/constrained_motion.hpp>
#include <kanexpr/numeric/typical_magnitudes.hpp>
#include <kanexpr/steps/fixed_step.hpp>
#include <kanexpr/steps/unreduced_equations.hpp>

#include <Eigen/Core>
#include <cmath>
#include <string_view>
#include <type_traits>

/// Steps near positions in which constraints are linearly dependent, with the equations for all speeds.
namespace kanexpr::steps {

using compiled::omitted;
using compiled::survey_of;

/// Converts an argument of a step to the vector type of the system; returns zero if it was omitted.
template <class Vector, class Given>
Vector own_vector(const Given& given) {
  if constexpr (std::is_same_v<Given, omitted>)
    return Vector::Zero();
  else
    return compiled::forwarded<Vector>(given);
}

/// The equations for all speeds, evaluated at the nearest state that satisfies the constraints, in the form
/// that the integration methods require.
template <class System, class Number, class Inputs>
class passing_equations {
  using parameters = parameter_values<System, Number>;
  using inputs = input_values<System, Number>;
  using unreduced =
      unreduced_equations<System, Number, parameters, inputs, unreduced_rows::configuration_and_velocities>;
  using motion = numeric::constrained_motion<unreduced>;
  using quantity = mechanics::quantity;
  using vector = typename unreduced::state;
  static constexpr int n = unreduced::fixed_coordinates, o = unreduced::fixed_speeds;

public:
  passing_equations(Number t, const state<System, Number>& x, const parameters& p, const Inputs& r)
      : r_(r), of_(t, p, own_vector<inputs>(inputs_at(r, t, x))),
        moving_(of_, numeric::typical_magnitudes(of_, vector(x)), x) {}

  template <quantity wanted, class Time>
  auto get(const Time& t, const state<System, Number>& x) const {
    const status s = find(t, x);
    if constexpr (wanted == quantity::rhs)
      return with_status<vector>(found_.rates, s);
    else if constexpr (wanted == quantity::udot)
      return with_status<Eigen::Matrix<Number, o, 1>>(found_.rates.template tail<o>(), s);
    else
      return with_status<Eigen::Matrix<Number, n, 1>>(found_.rates.template head<n>(), s);
  }
  template <class Time>
  const passing_equations& held(const Time&, const state<System, Number>&) const {
    return *this;
  }
  static status finite(const Number& value, std::string_view cause) {
    return lower::scalar_math<Number>::is_finite(value) ? status() : status(cause);
  }
  template <class Time>
  status corrected(const Time& t, state<System, Number>& x) const {
    const status s = find(t, x);
    if (s) static_cast<vector&>(x) = found_.x;
    return s;
  }
  static constexpr bool has_pivots() { return false; }
  static status same_side(const Number&, const Number&) { return {}; }

  /// Whether a state is close enough to the constraints to be the result of a step.
  template <class Time>
  bool satisfies_constraints(const Time& t, const state<System, Number>& x) const {
    const status s = find(t, x);
    return s && (found_.x - x).norm() <= Number(1e-2) * (1 + x.norm());
  }

private:
  template <class Time>
  status find(const Time& t, const state<System, Number>& x) const {
    const Number now = static_cast<Number>(t);
    of_.go_to(now, own_vector<inputs>(inputs_at(r_, t, x)));
    return moving_.find(x, found_);
  }

  const Inputs& r_;
  mutable unreduced of_;
  mutable motion moving_;
  mutable typename motion::motion found_{};
};

/// Whether the parameters and inputs are vectors of the sizes that the system requires.
template <class System, class Parameters, class Inputs>
constexpr bool can_be_passed_on() {
  constexpr bool has_parameters = survey_of<System>.parameters == 0 && std::is_same_v<Parameters, omitted>,
                 has_inputs = !inputs_hold<Inputs> ||
                              (survey_of<System>.inputs == 0 && std::is_same_v<Inputs, omitted>);
  return (has_parameters || compiled::can_forward<System, compiled::symbols_of::parameters, Parameters>()) &&
         (has_inputs || compiled::can_forward<System, compiled::symbols_of::inputs, Inputs>());
}

/// The equations for the independent speeds; evaluating them also records whether a step comes close to a
/// singular position.
template <class System, int corrections, class Parameters, class Inputs>
struct watching_equations : compiled_equations<System, corrections, Parameters, Inputs> {
  mutable bool is_near = false;

  template <class Number>
  status same_side(const Number& before, const Number& after) const {
    constexpr double part = 0.25; // the largest relative change of a determinant per step
    is_near = is_near || !(std::abs(after - before) <= part * std::abs(after));
    return {};
  }
};

template <class Method, class System, int corrections>
struct passing_step {
  template <class Time, class Number, class Parameters = omitted, class Inputs = omitted>
  status operator()(Time& t, state<System, Number>& x, std::type_identity_t<Time> h, const Parameters& p = {},
                    const Inputs& r = {}) const {
    if constexpr (survey_of<System>.constraints == 0) {
      return advanced<Method, System, corrections>(t, x, h, p, r);
    } else {
      const watching_equations<System, corrections, Parameters, const Inputs&> of{{p, r}};
      state<System, Number> next = x;
      status s = stepped<Method>(of, t, next, h);
      if (!s || of.is_near) s = pass(s, t, x, h, p, r, next);
      if (!s) return compiled::not_finite<System>::cause_of(s, x, p, inputs_at(r, t, x));
      t = static_cast<Time>(t + h), x = next;
      return s;
    }
  }

private:
  /// Takes the step with the equations for all speeds; if this also fails, the result of the regular step is
  /// kept.
  template <class Time, class Number, class Parameters, class Inputs>
  [[gnu::cold, gnu::noinline]] static status
  pass(const status& before, const Time& t, const state<System, Number>& x, const Time& h,
       const Parameters& p, const Inputs& r, state<System, Number>& next) {
    if constexpr (can_be_passed_on<System, Parameters, Inputs>()) {
      const auto parameters = own_vector<parameter_values<System, Number>>(p);
      const passing_equations<System, Number, Inputs> of(static_cast<Number>(t), x, parameters, r);
      state<System, Number> there = x;
      if (of.satisfies_constraints(t, x) && stepped<Method>(of, t, there, h)) {
        next = there;
        return {};
      }
    }
    return before;
  }
};

} // namespace kanexpr::steps

namespace kanexpr {

/// A fixed-length step that can pass through positions in which the constraints of a system are linearly
/// dependent, such as those of a linkage whose bars are in line: `passing<runge_kutta_4<System>> step;`. Near
/// such positions it uses the equations for all speeds at states projected onto the constraints, at about
/// thirty times the cost; elsewhere it is identical to `Step`. It neither allocates nor throws.
template <class Step>
struct passing : steps::passing_step<typename Step::method, typename Step::system, Step::corrections> {};

} // namespace kanexpr
