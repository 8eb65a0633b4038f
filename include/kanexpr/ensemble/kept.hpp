#pragma once

#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/ensemble/extreme.hpp>
#include <kanexpr/ensemble/layout.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/simulate/input_source.hpp>
#include <kanexpr/simulate/simulation.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace kanexpr {

/// A run of a study as it ended, of which results are formed.
template <class System>
struct ended_run {
  const run_values& given;
  const simulation<System>& run; ///< with the samples that it was asked for
  const parameter_values<System>& p;
  const input_values<System>& r;             ///< where it ended
  const kanexpr::trajectory<System>& motion; ///< every step
  const input_source<System>& inputs;

  /// Between the steps, with the inputs as they are there.
  sample<System> at(double t) const {
    sample<System> found = *motion.at(t);
    inputs.give(t, found.x, found.r);
    return found;
  }
};

template <class System, class Number>
struct kept_in_steps;

/// A number that a study keeps of each run.
template <class System>
struct kept {
  column_label what;
  std::function<double(const ended_run<System>&)> of;
  bool needs_motion = false;   ///< every step, with what lies between
  bool needs_samples = false;  ///< those that the simulation is asked for
  bool may_be_missing = false; ///< not a number then
  std::string event{};         ///< of which it speaks
  std::string text{};          ///< by which a study is known again, beside the name
  std::string symbol{};        ///< whose unit it has if it was told none; empty: of none
};

namespace ensembles {

/// An expression that a study keeps, which must be a scalar.
template <auto expression>
struct watched {
  static constexpr describe::phrase words = describe::phrase_of<expression>;
  static constexpr mechanics::sentence mistake = [] {
    if (words.kind == describe::shape::scalar) return mechanics::sentence{};
    return mechanics::sentence({"what a study keeps", words.size > 0 ? ", with " : "",
                                deriving::name_in(words), words.size > 0 ? "," : "",
                                deriving::is_a(words.kind), "it must be a scalar"});
  }();
  static constexpr bool is_scalar = !mistake;
  static_assert(deriving::tell<watched>());

  template <class System>
  static double at(double t, const state<System>& x, const parameter_values<System>& p,
                   const input_values<System>& r) {
    if constexpr (is_scalar) return out_of_line<function<System, expression>>{}(t, x, p, r);
    return 0;
  }

  /// By which it is known again, of the library that holds its code.
  template <class System>
  static std::uint64_t digest() {
    if constexpr (is_scalar) return out_of_line<function<System, expression>>::digest();
    return 0;
  }
  /// And where it is expanded.
  template <class System>
  static constexpr std::uint64_t expanded_digest() {
    if constexpr (is_scalar) return compiled::digest_of_function<function<System, expression>>;
    return 0;
  }

  /// That of a symbol with something behind it; else it has to be given one.
  static std::string name(const char* what) {
    const std::string of = symbol();
    return of.empty() ? of : of + what;
  }
  static std::string symbol() {
    if constexpr (requires { symbol_name(expression); }) return symbol_name(expression).name();
    return {};
  }
};

enum class in_time { at_end, greatest, least };

/// What of an expression is kept, of whichever system.
template <auto expression, in_time when>
struct kept_expression {
  column_label what;

  template <class System>
  operator kept<System>() const {
    using watched = ensembles::watched<expression>;
    const std::string text = text_of(watched::template digest<System>());
    if constexpr (when == in_time::at_end) {
      const auto of = [](const ended_run<System>& ended) {
        return watched::template at<System>(ended.run.time, ended.run.state, ended.p, ended.r);
      };
      return {what, of, false, false, false, {}, text, watched::symbol()};
    } else {
      const auto of = [](const ended_run<System>& ended) {
        constexpr double sign = when == in_time::greatest ? 1 : -1;
        return sign * greatest_along(
                          ended.motion, [&](double t) { return ended.at(t); },
                          [&](const sample<System>& s) {
                            return sign * watched::template at<System>(s.t, s.x, ended.p, s.r);
                          });
      };
      return {what, of, true, false, false, {}, text, watched::symbol()};
    }
  }
  template <class System, class Number>
  operator kept_in_steps<System, Number>() const {
    const auto of = [](double t, const auto& x, const auto& p, const auto& r) {
      if constexpr (watched<expression>::is_scalar)
        return function<System, expression>{}(static_cast<Number>(t), x, p, r);
      else
        return x[0];
    };
    return {what, when, of, text_of(watched<expression>::template expanded_digest<System>()),
            watched<expression>::symbol()};
  }

private:
  /// By which it is known from others.
  static std::string text_of(std::uint64_t digest) {
    return std::to_string(static_cast<int>(when)) + ' ' + std::to_string(digest);
  }
};

enum class of_event { first_time, last_time, count };

template <of_event asked>
struct kept_event {
  std::string event;
  column_label what;

  template <class System>
  operator kept<System>() const {
    const auto of = [name = event](const ended_run<System>& ended) {
      double time = std::numeric_limits<double>::quiet_NaN(), count = 0;
      for (const occurrence& each : ended.run.events)
        if (each.name == name) {
          ++count;
          if (asked != of_event::first_time || count < 2) time = each.t;
        }
      return asked == of_event::count ? count : time;
    };
    return {what, of, false, false, asked != of_event::count, event, std::to_string(static_cast<int>(asked))};
  }
};

/// What a function of the user forms of a run.
template <class Function>
struct kept_result {
  column_label what;
  Function of;

  template <class System>
  operator kept<System>() const {
    const auto formed = [f = of](const ended_run<System>& ended) -> double {
      if constexpr (std::invocable<const Function&, const run_values&, const simulation<System>&>)
        return f(ended.given, ended.run);
      else
        return f(ended.run);
    };
    return {what, formed, false, true};
  }
};

} // namespace ensembles

/// A coordinate, speed, parameter or expression of the model where the run ends: `at_end<q1>()`,
/// `at_end<dot(position_of<P, O>, N::y)>("height", "m")`. A symbol lends its own name, as q1_end.
template <auto expression>
ensembles::kept_expression<expression, ensembles::in_time::at_end>
at_end(std::string name = ensembles::watched<expression>::name("_end"), std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}

/// The greatest that an expression is in a run, between the steps of the integrator too; of a symbol, as
/// q1_greatest.
template <auto expression>
ensembles::kept_expression<expression, ensembles::in_time::greatest>
greatest(std::string name = ensembles::watched<expression>::name("_greatest"), std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}
template <auto expression>
ensembles::kept_expression<expression, ensembles::in_time::least>
least(std::string name = ensembles::watched<expression>::name("_least"), std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}

/// When an event happens for the first time; not a number in runs where it does not.
inline ensembles::kept_event<ensembles::of_event::first_time>
first_time_of(std::string event, std::string name, std::string unit = "s") {
  return {std::move(event), {std::move(name), std::move(unit)}};
}
inline ensembles::kept_event<ensembles::of_event::last_time> last_time_of(std::string event, std::string name,
                                                                          std::string unit = "s") {
  return {std::move(event), {std::move(name), std::move(unit)}};
}
/// How often it happens.
inline ensembles::kept_event<ensembles::of_event::count> times_of(std::string event, std::string name) {
  return {std::move(event), {std::move(name)}};
}

/// What a function forms of the simulation: `result("turns", [](const simulation<System>& run) { … })`. Its
/// samples are those that the study asks its simulations for. A function of two arguments is told first what
/// the run was given, the `run_values`.
template <class Function>
ensembles::kept_result<Function> result(std::string name, Function of, std::string unit = {}) {
  return {{std::move(name), std::move(unit)}, std::move(of)};
}

} // namespace kanexpr
