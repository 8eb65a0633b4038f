#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/batches/batch.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/ensembles/maximum_along.hpp>
#include <kanexpr/ensembles/runs.hpp>
#include <kanexpr/ensembles/study_interface.hpp>
#include <kanexpr/simulations/inputs/input_source.hpp>
#include <kanexpr/simulations/simulation.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace kanexpr {

namespace ensembles {

enum class aggregate { at_end, greatest, least };

} // namespace ensembles

/// A completed run, from which its outputs are computed.
template <class System>
struct ended_run {
  const run_values& varied;
  const simulation<System>& run; ///< with the requested samples
  const parameter_values<System>& p;
  const input_values<System>& r;             ///< the inputs at the end of the run
  const kanexpr::trajectory<System>& motion; ///< every step
  const input_source<System>& inputs;

  /// Interpolates between the steps, with the inputs at that time.
  sample<System> at(double t) const {
    sample<System> found = *motion.at(t);
    inputs.give(t, found.x, found.r);
    return found;
  }
};

/// A number that a study keeps for each simulation.
template <class System>
struct run_output {
  column_label what;
  std::function<double(const ended_run<System>&)> of;
  std::string symbol{};        ///< the symbol whose unit is the default; empty: none
  std::string identity{};      ///< distinguishes outputs with the same name
  std::string event{};         ///< the event that it requires
  bool needs_motion = false;   ///< every step, with interpolation
  bool needs_samples = false;  ///< the samples that the options request
  bool may_be_missing = false; ///< NaN is a valid value
};

/// A number that a study in steps keeps for each run. It is evaluated in all lanes.
template <class System, class Number = double>
struct step_output {
  using vectors = batch<batches::default_lanes<Number>, Number>;

  column_label what;
  ensembles::aggregate when = ensembles::aggregate::at_end;
  std::function<typename vectors::number(double t, const typename vectors::template state<System>&,
                                         const typename vectors::template parameters<System>&,
                                         const typename vectors::template inputs<System>&)>
      of;
  std::string symbol{};
  std::string identity{};
};

namespace ensembles {

/// The expression of an output, which must be a scalar.
template <auto expression>
struct output_expression {
  static constexpr describe::phrase words = describe::phrase_of<expression>;
  static constexpr base::sentence mistake = [] {
    if (words.kind == describe::shape::scalar) return base::sentence{};
    return base::sentence({"the output of a study", words.size > 0 ? ", with " : "",
                           derivation::name_in(words), words.size > 0 ? "," : "",
                           derivation::is_a(words.kind), "it must be a scalar"});
  }();
  static constexpr bool is_scalar = !mistake;
  static_assert(derivation::report<output_expression>());

  template <class System>
  static double at(double t, const state<System>& x, const parameter_values<System>& p,
                   const input_values<System>& r) {
    if constexpr (is_scalar) return out_of_line<function<System, expression>>{}(t, x, p, r);
    return 0;
  }
  static std::string symbol() {
    if constexpr (requires { symbol_name(expression); }) return symbol_name(expression).name();
    return {};
  }
  /// The default name of a column; an expression other than a symbol has none.
  static std::string name(const char* suffix) { return symbol().empty() ? symbol() : symbol() + suffix; }
};

/// The output of an expression, for any system.
template <auto expression, aggregate when>
struct expression_output {
  using output = output_expression<expression>;
  column_label what;

  template <class System>
  operator run_output<System>() const {
    std::uint64_t digest = 0; // from the library that contains the code
    if constexpr (output::is_scalar) digest = out_of_line<function<System, expression>>::digest();
    const auto of = [](const ended_run<System>& ended) {
      const auto value = [&](double t, const auto& x, const auto& r) {
        return output::template at<System>(t, x, ended.p, r);
      };
      if constexpr (when == aggregate::at_end) {
        return value(ended.run.time, ended.run.state, ended.r);
      } else {
        constexpr double sign = when == aggregate::greatest ? 1 : -1;
        return sign * maximum_along(
                          ended.motion, [&](double t) { return ended.at(t); },
                          [&](const sample<System>& s) { return sign * value(s.t, s.x, s.r); });
      }
    };
    return {.what = what,
            .of = of,
            .symbol = output::symbol(),
            .identity = identity(digest),
            .needs_motion = when != aggregate::at_end};
  }
  template <class System, class Number>
  operator step_output<System, Number>() const {
    const auto of = [](double t, const auto& x, const auto& p, const auto& r) {
      if constexpr (output::is_scalar)
        return function<System, expression>{}(static_cast<Number>(t), x, p, r);
      else
        return x[0];
    };
    std::uint64_t digest = 0;
    if constexpr (output::is_scalar) digest = compiled::digest_of_function<function<System, expression>>;
    return {what, when, of, output::symbol(), identity(digest)};
  }

private:
  static std::string identity(std::uint64_t digest) {
    return std::to_string(static_cast<int>(when)) + ' ' + std::to_string(digest);
  }
};

enum class of_event { first_time, last_time, count };

template <of_event which>
struct event_output {
  std::string event;
  column_label what;

  template <class System>
  operator run_output<System>() const {
    const auto of = [name = event](const ended_run<System>& ended) {
      double time = std::numeric_limits<double>::quiet_NaN(), count = 0;
      for (const occurrence& each : ended.run.events)
        if (each.name == name) {
          ++count;
          if (which != of_event::first_time || count < 2) time = each.t;
        }
      return which == of_event::count ? count : time;
    };
    return {.what = what,
            .of = of,
            .identity = std::to_string(static_cast<int>(which)),
            .event = event,
            .may_be_missing = which != of_event::count};
  }
};

template <class Function>
struct function_output {
  column_label what;
  Function of;

  template <class System>
  operator run_output<System>() const {
    const auto call = [f = of](const ended_run<System>& ended) -> double {
      if constexpr (std::invocable<const Function&, const run_values&, const simulation<System>&>)
        return f(ended.varied, ended.run);
      else
        return f(ended.run);
    };
    return {.what = what, .of = call, .needs_samples = true};
  }
};

} // namespace ensembles

/// The value of an expression at the end of each run: `at_end<q1>()`, `at_end<dot(position_of<P, O>,
/// N::y)>("height", "m")`. The default name for a symbol q1 is q1_end.
template <auto expression>
ensembles::expression_output<expression, ensembles::aggregate::at_end>
at_end(std::string name = ensembles::output_expression<expression>::name("_end"), std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}

/// The maximum of an expression over each run, including between the steps of the integrator. The default
/// name for a symbol q1 is q1_greatest.
template <auto expression>
ensembles::expression_output<expression, ensembles::aggregate::greatest>
greatest(std::string name = ensembles::output_expression<expression>::name("_greatest"),
         std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}
/// The minimum of an expression over each run, including between the steps of the integrator. The default
/// name for a symbol q1 is q1_least.
template <auto expression>
ensembles::expression_output<expression, ensembles::aggregate::least>
least(std::string name = ensembles::output_expression<expression>::name("_least"), std::string unit = {}) {
  return {{std::move(name), std::move(unit)}};
}

/// The time at which an event first occurs; NaN in runs in which it does not.
inline ensembles::event_output<ensembles::of_event::first_time>
first_time_of(std::string event, std::string name, std::string unit = "s") {
  return {std::move(event), {std::move(name), std::move(unit)}};
}
/// The time at which an event last occurs, by default in s; NaN in runs in which it does not.
inline ensembles::event_output<ensembles::of_event::last_time>
last_time_of(std::string event, std::string name, std::string unit = "s") {
  return {std::move(event), {std::move(name), std::move(unit)}};
}
/// The number of times an event occurs.
inline ensembles::event_output<ensembles::of_event::count> times_of(std::string event, std::string name) {
  return {std::move(event), {std::move(name)}};
}

/// A function of each simulation: `result("turns", [](const simulation<System>& run) { … })`, with the
/// samples that the study requests. A function of two arguments also receives the varied values, as `const
/// run_values&`.
template <class Function>
ensembles::function_output<Function> result(std::string name, Function of, std::string unit = {}) {
  return {{std::move(name), std::move(unit)}, std::move(of)};
}

} // namespace kanexpr
