#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/base/digits.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The times and columns of an animation, and checks of its numbers.
namespace kanexpr::animate {

inline std::string at_time(double t) {
  char digits[32];
  return " at t = " + std::string(digits, std::to_chars(digits, digits + sizeof digits, t).ptr);
}

/// The page computes in single precision, whose squares of lengths must neither overflow nor vanish.
inline constexpr double largest_length = 1e15, least_length = 1e-15;
inline constexpr const char* range_of_lengths = "; a page can show lengths from 1e-15 to 1e15";

/// Checks a size or a scale. A scale may be negative, which mirrors the mesh.
inline std::string check_number(const animation::shape& s, double size) {
  const bool is_scale = s.kind == "mesh";
  if (numeric::is_finite(size) && (size > 0 || (is_scale && size < 0))) {
    if (is_scale || size <= largest_length) return {};
    return "a dimension of the " + s.name + " is " + base::digits(size, 3) + range_of_lengths;
  }
  if (is_scale) return "every scale of the " + s.name + " must be finite and nonzero";
  return "every dimension of the " + s.name + " must be positive and finite";
}

/// Checks the placement of a shape at one time.
inline std::string check_placement(const animation::shape& s, const placement& here, double t) {
  const bool is_arrow = s.kind == "arrow";
  if (is_arrow && !numeric::all_finite(here.end))
    return "the vector of the " + s.name + " is not finite" + at_time(t);
  if (!numeric::all_finite(here.position) || !numeric::all_finite(here.end))
    return "the position of the " + s.name + " is not finite" + at_time(t);
  if (!numeric::all_finite(here.orientation))
    return "the orientation of the " + s.name + " is not finite" + at_time(t);
  const double distance = (std::max)(here.position.stableNorm(), is_arrow ? 0.0 : here.end.stableNorm());
  if (distance > largest_length)
    return "the " + s.name + " is " + base::digits(distance, 3) + " away from the origin" + at_time(t) +
           range_of_lengths;
  return {};
}

/// Checks that the lengths of an animation are not all too small. The lengths of a mesh are unknown.
inline std::string check_smallness(const animation& a) {
  double largest = 0;
  for (const animation::shape& s : a.shapes) {
    if (s.kind == "mesh") return {};
    for (const placement& here : s.placements)
      largest = (std::max)({largest, here.position.lpNorm<Eigen::Infinity>(),
                            s.kind == "arrow" ? 0.0 : here.end.lpNorm<Eigen::Infinity>()});
    const std::size_t lengths = s.kind == "coil" ? 1 : s.sizes.size(); // a coil also has a number of turns
    for (std::size_t i = 0; i < lengths && i < s.sizes.size(); ++i) largest = (std::max)(largest, s.sizes[i]);
  }
  if (!(largest > 0) || largest >= least_length) return {};
  return "the largest length in the picture is " + base::digits(largest, 3) + range_of_lengths;
}

/// Checks that an animation shows something, and that all its shapes and columns have an entry for each time.
inline std::string check_entries(const animation& a) {
  if (a.times.empty()) return "the animation has no times";
  if (a.shapes.empty()) return "the animation has no shapes";
  const auto of_times = [&](std::size_t entries, const char* one) {
    return std::to_string(entries) + ' ' + one + (entries == 1 ? "" : "s") + " for " +
           std::to_string(a.times.size()) + (a.times.size() == 1 ? " time" : " times");
  };
  for (const animation::shape& s : a.shapes)
    if (s.placements.size() != s.places * a.times.size())
      return "the " + s.name + " has " + of_times(s.placements.size(), "placement") +
             (s.places == 1 ? "" : " and " + std::to_string(s.places) + " places");
  for (const animation::column& c : a.columns)
    if (c.values.size() != a.times.size()) return c.name + " has " + of_times(c.values.size(), "value");
  return {};
}

/// Returns a message that names the first value in an animation that is not finite or out of range; empty if
/// there is none.
inline std::string check_numbers(const animation& a) {
  if (!numeric::all_finite(a.up) || !(a.up.norm() > 0.5))
    return "the direction of up must be a nonzero vector";
  if (a.seen_from && (!numeric::all_finite(*a.seen_from) || !(a.seen_from->norm() > 0.5)))
    return "the direction of seen_from must be a nonzero vector";
  if (a.ground && !numeric::is_finite(*a.ground)) return "the height of the ground must be finite";
  if (a.ground && std::abs(*a.ground) > largest_length)
    return "the height of the ground is " + base::digits(*a.ground, 3) + range_of_lengths;
  for (const animation::column& c : a.columns)
    for (std::size_t k = 0; k < c.values.size(); ++k)
      if (!numeric::is_finite(c.values[k])) return c.name + " is not finite" + at_time(a.times[k]);
  for (const animation::shape& s : a.shapes) {
    for (double size : s.sizes)
      if (std::string cause = check_number(s, size); !cause.empty()) return cause;
    for (std::size_t k = 0; k < s.placements.size(); ++k)
      if (std::string cause = check_placement(s, s.placements[k], a.times[k / s.places]); !cause.empty())
        return cause;
  }
  return check_smallness(a);
}

/// The names of the coordinates, speeds and inputs, without values; `units` is null if the model states none.
inline std::vector<animation::column> columns_of(const derivation::survey& known,
                                                 const mechanics::unit_table* units) {
  std::vector<animation::column> columns;
  for (int i = 0; i < known.coordinates + known.speeds; ++i) {
    std::string name(known.names[i].view());
    const bool is_state_variable = i >= known.first_state_variable();
    if (known.takes_rates_as_speeds && i >= known.coordinates && !is_state_variable)
      name = std::string(known.names[i - known.coordinates].view()) + '\'';
    columns.push_back({name,
                       {},
                       i < known.coordinates ? "Coordinates"
                       : is_state_variable   ? "State variables"
                                             : "Speeds",
                       derivation::unit_label(units, known, i)});
  }
  const int first = known.first_of(symbolic::symbol_kind::input);
  for (int i = 0; i < known.inputs; ++i)
    columns.push_back({std::string(known.names[first + i].view()),
                       {},
                       "Inputs",
                       derivation::unit_label(units, known, first + i)});
  return columns;
}

/// Adds the time, the state and the inputs of a sample to the columns; sets the failure if the time or the
/// state is invalid.
inline void add_sample(animation& a, double t, std::span<const double> x, std::span<const double> r) {
  for (const double entry : x)
    if (!numeric::is_finite(entry)) a.failure = "the state is not finite" + at_time(t);
  if (!numeric::is_finite(t)) a.failure = "the time of a sample is not finite";
  if (!a.times.empty() && t < a.times.back()) a.failure = "the times of the samples decrease" + at_time(t);
  a.times.push_back(t);
  for (std::size_t i = 0; i < a.columns.size(); ++i)
    a.columns[i].values.push_back(i < x.size() ? x[i] : r[i - x.size()]);
}

/// Removes the columns of inputs that have no value at some time, which a picture need not depend on.
inline void drop_unset_inputs(animation& a) {
  std::erase_if(a.columns, [](const animation::column& c) {
    return c.group == "Inputs" &&
           !std::ranges::all_of(c.values, [](double v) { return numeric::is_finite(v); });
  });
}

} // namespace kanexpr::animate
