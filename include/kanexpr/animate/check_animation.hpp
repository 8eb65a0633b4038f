#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <charconv>
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

/// Checks a size or a scale. A scale may be negative, which mirrors the mesh.
inline std::string check_number(const animation::shape& s, double size) {
  const bool is_scale = s.kind == "mesh";
  if (numeric::is_finite(size) && (size > 0 || (is_scale && size < 0))) return {};
  if (is_scale) return "every scale of the " + s.name + " must be finite and nonzero";
  return "every dimension of the " + s.name + " must be positive and finite";
}

/// Returns a message that names the first value in an animation that is not finite or out of range; empty if
/// there is none.
inline std::string check_numbers(const animation& a) {
  if (!numeric::all_finite(a.up) || !(a.up.norm() > 0.5))
    return "the direction of up must be a nonzero vector";
  if (a.seen_from && (!numeric::all_finite(*a.seen_from) || !(a.seen_from->norm() > 0.5)))
    return "the direction of seen_from must be a nonzero vector";
  if (a.ground && !numeric::is_finite(*a.ground)) return "the height of the ground must be finite";
  for (const animation::column& c : a.columns)
    for (std::size_t k = 0; k < c.values.size(); ++k)
      if (!numeric::is_finite(c.values[k])) return c.name + " is not finite" + at_time(a.times[k]);
  for (const animation::shape& s : a.shapes) {
    for (double size : s.sizes)
      if (std::string cause = check_number(s, size); !cause.empty()) return cause;
    for (std::size_t k = 0; k < s.placements.size(); ++k) {
      const placement& here = s.placements[k];
      if (s.kind == "arrow" && !numeric::all_finite(here.end))
        return "the vector of the " + s.name + " is not finite" + at_time(a.times[k]);
      if (!numeric::all_finite(here.position) || !numeric::all_finite(here.end))
        return "the position of the " + s.name + " is not finite" + at_time(a.times[k]);
      if (!numeric::all_finite(here.orientation))
        return "the orientation of the " + s.name + " is not finite" + at_time(a.times[k]);
    }
  }
  return {};
}

/// The names of the coordinates, speeds and inputs, without values.
inline std::vector<animation::column> columns_of(const derivation::survey& known) {
  std::vector<animation::column> columns;
  for (int i = 0; i < known.coordinates + known.speeds; ++i) {
    std::string name(known.names[i].view());
    if (known.takes_rates_as_speeds && i >= known.coordinates)
      name = std::string(known.names[i - known.coordinates].view()) + '\'';
    columns.push_back({name, {}, i < known.coordinates ? "Coordinates" : "Speeds", {}});
  }
  const int first = known.first_of(symbolic::symbol_kind::input);
  for (int i = 0; i < known.inputs; ++i)
    columns.push_back({std::string(known.names[first + i].view()), {}, "Inputs", {}});
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
