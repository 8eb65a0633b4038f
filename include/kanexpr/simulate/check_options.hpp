#pragma once

#include <kanexpr/simulate/simulation_options.hpp>
#include <kanexpr/simulate/sundials/stepper.hpp>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

/// What is wrong with the way a simulation is asked for, before its first step.
namespace kanexpr::simulated {

inline std::string digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

inline std::string check_span(const time_span& span) {
  if (!std::isfinite(span.from) || !std::isfinite(span.to)) return "the time span is not finite";
  if (span.to < span.from)
    return "the time span ends at " + digits(span.to) + ", before it begins at " + digits(span.from);
  return {};
}

inline std::string check_output_times(const std::vector<double>& times, const time_span& span) {
  double last = span.from;
  for (double t : times) {
    if (!(t >= span.from && t <= span.to))
      return "the output time " + digits(t) + " is outside the time span";
    if (t < last) return "the output time " + digits(t) + " comes after " + digits(last);
    last = t;
  }
  return {};
}

template <class System>
std::string check_options(const simulation_options<System>& o, const time_span& span) {
  if (const std::string wrong = check_span(span); !wrong.empty()) return wrong;
  if (o.inputs.problem()) return std::string(o.inputs.problem().view());
  if (!(o.relative_tolerance > 0) || !(o.absolute_tolerance > 0)) return "a tolerance must be positive";
  if (!(o.most_drift > 0)) return "the drift that is allowed must be positive";
  if (!(o.output_every >= 0)) return "the time between two samples must be positive";
  if (o.output_every > 0 && !o.output_times.empty())
    return "samples are asked for at regular and at particular times; give output_every or output_times";
  if (!(o.first_step >= 0) || !(o.least_step >= 0) || !(o.greatest_step >= 0))
    return "the size of a step must be positive";
  if (!o.keep && !o.each_sample) return "samples are neither kept nor handed to a function";
  for (std::size_t i = 0; i < o.events.size(); ++i)
    if (!o.events[i].value) return "the event " + o.events[i].name + " has no function whose zeros it is";
  return check_output_times(o.output_times, span);
}

/// The absolute tolerance of each entry of the state.
template <class System>
std::string read_tolerances(const simulation_options<System>& o, std::vector<double>& tolerances) {
  kanexpr::state<System> each;
  each.setConstant(o.absolute_tolerance);
  compiled::values_reader reader(compiled::survey_of<System>, System::record, type_name<System>(),
                                 range_of(compiled::symbols_of::state, compiled::survey_of<System>),
                                 each.data());
  for (const named_value& given : o.absolute_tolerances) reader.read(given.what, given.value);
  reader.look_for_infinite();
  if (reader.problem()) return "of the tolerances, " + std::string(reader.problem().view());
  if (!(each.array() > 0).all()) return "a tolerance must be positive";
  tolerances.assign(each.begin(), each.end());
  return {};
}

} // namespace kanexpr::simulated
