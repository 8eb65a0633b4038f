#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/surveyed.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <string_view>
#include <type_traits>
#include <utility>

/// Mistakes in a call of a compiled function.
namespace kanexpr::compiled {

template <auto wanted>
constexpr std::string_view result_name() {
  using mechanics::quantity;
  if constexpr (std::is_same_v<std::remove_const_t<decltype(wanted)>, quantity>)
    return mechanics::row_of(wanted).called;
  if constexpr (requires { wanted.result_name(); }) return wanted.result_name();
  return "the expression";
}

/// Names an argument that the code loads but the call omits.
template <class System, class Code>
constexpr base::sentence missing_argument(std::string_view result, symbolic::symbol_kind kind,
                                          std::string_view what, std::string_view way) {
  constexpr const derivation::survey& s = survey_of<System>;
  using symbolic::symbol_kind;
  const bool rate = kind == symbol_kind::speed_rate, second = rate && s.takes_rates_as_speeds;
  const symbol_kind named = second ? symbol_kind::coordinate : rate ? symbol_kind::speed : kind;
  for (int i = 0; i < Code::tape.sizes.loads; ++i) {
    if (Code::tape.loads[i].from != kind) continue;
    const int place = s.first_of(named) + Code::tape.loads[i].position;
    return base::sentence({result, " needs the ", second ? "second derivative of coordinate " : what,
                           s.names[place].view(), ": call it as ", result, way});
  }
  return {};
}

template <class Code>
constexpr bool loads_time() {
  for (int i = 0; i < Code::tape.sizes.loads; ++i)
    if (Code::tape.loads[i].from == symbolic::symbol_kind::time) return true;
  return false;
}

/// Whether the user-supplied functions that `Code` calls accept a scalar type, in compiled code or in an
/// interpreter.
template <class Code, class Number, bool is_interpreted, auto wanted>
struct external_calls {
  template <int index>
  static constexpr bool takes() {
    using function = decltype(callable_of(symbolic::external_key<Code::tape.externals[index]>{}));
    if constexpr (is_interpreted)
      return lower::scalar_math<Number>::template interprets<function>;
    else
      return lower::scalar_math<Number>::template calls<function>;
  }

  static constexpr base::sentence mistake = []<int... index>(std::integer_sequence<int, index...>) {
    std::string_view refusing;
    ((refusing.empty() && !takes<index>() ? void(refusing = Code::tape.externals[index]->called.view())
                                          : void()),
     ...);
    if (refusing.empty()) return base::sentence();
    return base::sentence({result_name<wanted>(), " is evaluated with the scalar type ", type_name<Number>(),
                           ", which ", refusing, " does not accept"});
  }(std::make_integer_sequence<int, Code::tape.sizes.externals>{});
  static constexpr bool possible = !static_cast<bool>(mistake);
  static_assert(derivation::report<external_calls>());
};

template <class Code, class Number, bool is_interpreted, auto wanted, auto...>
constexpr bool can_call_externals() {
  if constexpr (Code::tape.sizes.externals > 0)
    return external_calls<Code, Number, is_interpreted, wanted>::possible;
  else
    return true;
}

/// Checks that an argument is the vector required there and belongs to the same system.
template <class System, symbols_of wanted, class Argument, class Keep>
constexpr void check_owner(std::string_view result, const Keep& keep) {
  using given = decltype(vector_owner_of(static_cast<const Argument*>(nullptr)));
  if constexpr (!given::template fits<System, wanted>)
    keep(given::template mistake<System, wanted>(base::sentence({result, " of "}).view()));
}

/// A call of a function, identified by the types of its arguments.
template <class System, class Code, class Time, class State, class Parameters, class Inputs,
          class Accelerations, auto first, auto... more>
struct call {
  /// Whether the model itself is free of mistakes.
  static constexpr bool sound =
      !static_cast<bool>(survey_of<System>.mistake) && !static_cast<bool>(Code::mistake);

  static constexpr base::sentence mistake = [] {
    using symbolic::symbol_kind;
    constexpr std::string_view system = type_name<System>(), result = result_name<first>();
    constexpr const derivation::survey& known = survey_of<System>;
    base::sentence found;
    if (!sound) return found;
    const auto keep = [&](const base::sentence& p) {
      if (!found) found = p;
    };
    check_owner<System, symbols_of::state, State>(result, keep);
    check_owner<System, symbols_of::parameters, Parameters>(result, keep);
    check_owner<System, symbols_of::inputs, Inputs>(result, keep);
    if (std::is_integral_v<typename State::Scalar>) keep(check_scalar<System, typename State::Scalar>());
    keep(check_size("state", system, entries_of<State>(), known.coordinates + known.speeds));
    keep(check_size("parameter", system, entries_of<Parameters>(), known.parameters));
    keep(check_size("input", system, entries_of<Inputs>(), known.inputs));
    keep(check_size("acceleration", system, entries_of<Accelerations>(), known.speeds));
    if (std::is_same_v<Parameters, omitted>)
      keep(
          missing_argument<System, Code>(result, symbol_kind::parameter, "parameter ",
                                         std::is_same_v<Accelerations, omitted> ? "(x, p)" : "(x, p, r, a)"));
    if (std::is_same_v<Inputs, omitted>)
      keep(missing_argument<System, Code>(result, symbol_kind::input, "input ", "(x, p, r)"));
    if (std::is_same_v<Accelerations, omitted>)
      keep(missing_argument<System, Code>(result, symbol_kind::speed_rate, "rate of speed ", "(x, p, r, a)"));
    if (std::is_same_v<Time, omitted> && loads_time<Code>())
      keep(base::sentence({result, " needs the time: call it as ", result, "(t, x, p, r)"}));
    return found;
  }();
  static_assert(derivation::report<call>());

  static constexpr bool possible = sound && !static_cast<bool>(mistake);
};

/// The arguments that follow the inputs in a call of a function that takes weights or a direction. `Weights`
/// and `Direction` are `omitted` if the function does not take them.
template <class System, class Code, class Weights, class Direction, derivation::extra_arguments given,
          auto first, auto... more>
struct weighted_call {
  static constexpr base::sentence mistake = [] {
    constexpr std::string_view system = type_name<System>(), result = result_name<first>();
    constexpr const derivation::survey& known = survey_of<System>;
    constexpr int state = known.coordinates + known.speeds;
    base::sentence found;
    if (static_cast<bool>(known.mistake) || static_cast<bool>(Code::mistake)) return found;
    const auto keep = [&](const base::sentence& p) {
      if (!found) found = p;
    };
    if (given.rates)
      keep(base::sentence({result, " cannot be evaluated together with a result at given rates of the "
                                   "speeds; evaluate them in two calls"}));
    if (given.weights && std::is_same_v<Weights, omitted>)
      keep(base::sentence({result, " needs a weight for each rate of the state: call it as ", result,
                           given.direction ? "(x, p, r, w, v)" : "(x, p, r, w)"}));
    if (given.direction && std::is_same_v<Direction, omitted>)
      keep(base::sentence({result, " needs a direction (a change in the state and the inputs): call it as ",
                           result, given.weights ? "(x, p, r, w, v)" : "(x, p, r, v)"}));
    keep(check_size("weight", system, entries_of<Weights>(), state));
    keep(check_size("direction", system, entries_of<Direction>(), state + known.inputs));
    return found;
  }();
  static_assert(derivation::report<weighted_call>());
  static constexpr bool possible = !static_cast<bool>(mistake);
};

/// The result of an invalid call. It can be used like any result (a vector, matrix or number with a status),
/// so that the mistake remains the only error.
template <class Number>
struct no_result : Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> {
  Number value{};
  kanexpr::status status{};
  operator Number() const { return value; }
  const Number& operator[](Eigen::Index) const { return value; }
};

} // namespace kanexpr::compiled
