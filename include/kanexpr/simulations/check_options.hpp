#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <unistd.h>

/// Checks the options of a simulation before its first step.
namespace kanexpr::simulations {

using base::digits;

/// Returns the physical memory in bytes; infinite if the system does not report it.
inline double memory_of_machine() {
#ifdef _SC_PHYS_PAGES
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
#else
  return numeric::infinity<double>;
#endif
}

/// Returns the shortest step that is not lost to rounding.
inline double shortest_step(const time_span& span) {
  return 4 * std::numeric_limits<double>::epsilon() * (span.to - span.from);
}

inline std::string check_span(const time_span& span) {
  if (!numeric::is_finite(span.from) || !numeric::is_finite(span.to)) return "the time span is not finite";
  if (span.to < span.from)
    return "the time span ends at " + digits(span.to) + ", before it begins at " + digits(span.from);
  const double length = span.to - span.from, latest = (std::max)(std::abs(span.from), std::abs(span.to));
  if (!numeric::is_finite(length)) return "the time span overflows double";
  if (length > 0 && length < 1000 * std::numeric_limits<double>::epsilon() * latest)
    return "the time span, " + digits(length) + " s, is too short: doubles near " + digits(latest) + " are " +
           digits(std::nextafter(latest, 2 * latest) - latest) + " s apart";
  if (length > 0 && shortest_step(span) < (std::numeric_limits<double>::min)())
    return "the time span, " + digits(length) + " s, is too short to be divided into steps";
  return {};
}

/// Checks a tolerance or a step size; a step size of 0 leaves the choice to the integrator.
inline std::string check_positive(double value, const std::string& what, bool may_be_zero) {
  if (!numeric::is_finite(value)) return what + " is not finite";
  return value > 0 || (may_be_zero && value >= 0) ? "" : what + " must be positive";
}

/// Checks that regular samples can be resolved in the time span and, if they are kept, fit into memory.
inline std::string check_output_every(double every, const time_span& span, std::size_t bytes_each) {
  if (!numeric::is_finite(every)) return "the time between two samples is not finite";
  if (base::equal(every, 0.0)) return {};
  if (!(every > 0)) return "the time between two samples must be positive";
  const std::string samples_every = "samples every " + digits(every) + " s";
  const double latest = (std::max)(std::abs(span.from), std::abs(span.to));
  if (span.from < span.to && every < 4 * std::numeric_limits<double>::epsilon() * latest)
    return samples_every + " are too closely spaced for times near " + digits(latest) +
           " in double precision";
  const double bytes = (span.to - span.from) / every * static_cast<double>(bytes_each);
  if (const double room = memory_of_machine(); bytes > room)
    return samples_every + " take " + digits(bytes / 1e9) + " GB, and the machine has " + digits(room / 1e9) +
           " GB; pass them to each_sample, with keep = false";
  return {};
}

inline std::string check_output_times(const std::vector<double>& times, const time_span& span) {
  double last = span.from;
  for (double t : times) {
    if (!(numeric::is_finite(t) && t >= span.from && t <= span.to))
      return "the output time " + digits(t) + " is outside the time span";
    if (t < last) return "the output time " + digits(t) + " is listed after " + digits(last);
    last = t;
  }
  return {};
}

inline std::string check_options(const settings& o, const time_span& span) {
  if (const std::string mistake = check_span(span); !mistake.empty()) return mistake;
  if (!o.mistake_in_inputs.empty()) return std::string(o.mistake_in_inputs);
  for (const double tolerance : {o.relative_tolerance, o.absolute_tolerance.value_or(1)})
    if (std::string mistake = check_positive(tolerance, "a tolerance", false); !mistake.empty())
      return mistake;
  if (o.relative_tolerance >= 1)
    return "the relative tolerance is " + digits(o.relative_tolerance) + "; it must be below 1";
  if (std::string mistake = check_output_every(o.output_every, span, o.keep ? o.bytes_of_sample : 0);
      !mistake.empty())
    return mistake;
  if (o.output_every > 0 && !o.output_times.empty())
    return "output_every and output_times are both set; set only one of them";
  for (const double step : {o.first_step, o.least_step, o.greatest_step})
    if (std::string mistake = check_positive(step, "a step size", true); !mistake.empty()) return mistake;
  if (o.greatest_step > 0 && o.least_step > o.greatest_step)
    return "the least step, " + digits(o.least_step) + ", is longer than the greatest, " +
           digits(o.greatest_step);
  if (o.greatest_step > 0 && o.greatest_step < shortest_step(span))
    return "the greatest step, " + digits(o.greatest_step) + ", is lost to rounding in a span of " +
           digits(span.to - span.from) + " s";
  if (o.most_steps <= 0) return "the maximum number of steps must be positive";
  if (!o.keep && !o.shows_samples) return "samples are neither kept nor passed to a function";
  for (const watched_event& each : o.events)
    if (!each.has_value) return "the event " + each.name + " has no function";
  return check_output_times(o.output_times, span);
}

/// Sets the absolute tolerance of each entry of a state; `sizes` are the magnitudes of the entries.
inline std::string read_tolerances(const system_interface& of, const settings& o,
                                   const Eigen::VectorXd& sizes, std::vector<double>& tolerances) {
  Eigen::VectorXd each = sizes;
  for (double& size : each) size *= 0.01 * o.relative_tolerance;
  if (o.absolute_tolerance) std::ranges::fill(each, *o.absolute_tolerance);
  compiled::values_reader reader(of.known, of.record, of.name,
                                 range_of(compiled::symbols_of::state, of.known), each.data());
  for (const named_value& given : o.absolute_tolerances) reader.read(given.what, given.value);
  reader.check_finite();
  if (reader.mistake()) return "in the tolerances, " + std::string(reader.mistake().view());
  if (!std::ranges::all_of(each, [](double size) { return size > 0; })) return "a tolerance must be positive";
  tolerances.assign(each.begin(), each.end());
  return {};
}

} // namespace kanexpr::simulations
