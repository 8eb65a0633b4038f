#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/skeleton/time_derivative.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// The kinematic differential equations of a frame whose angular velocity is declared.
namespace kanexpr::mechanics {

/// Returns a message that explains why a frame's orientation and declared angular velocity do not yield
/// equations; empty if they do.
constexpr base::sentence check_orientation_kinematics(const mechanism& m, int place, int reference) {
  const std::string_view called = m.frames[place].called.view(), in = m.frames[reference].called.view();
  if (place == reference || path::common_ancestor(m, place, reference) != reference)
    return base::sentence({"kinematics_of<", called, ", ", in, "> is not available: frame ", called,
                           " is not oriented relative to ", in});
  const int declared = m.frames[place].reference;
  if (declared == none)
    return base::sentence({"kinematics_of<", called, ", ", in, "> is not available: frame ", called,
                           " has no declared angular velocity"});
  if (declared != reference)
    return base::sentence({"kinematics_of<", called, ", ", in,
                           "> is not available: the angular velocity of frame ", called,
                           " is declared relative to ", m.frames[declared].called.view()});
  return {};
}

namespace detail {

constexpr sequence<expression> kinematics_of_parameters(const sequence<parameter_rate>& rates,
                                                        const components& omega,
                                                        symbolic::differentiation& along_time) {
  const components half{omega.x / 2, omega.y / 2, omega.z / 2};
  sequence<expression> vanishing;
  for (const parameter_rate& each : rates) {
    const expression rate = along_time.of(each.parameter);
    vanishing.push(rate - dot(each.by_turning, half));
  }
  return vanishing;
}

} // namespace detail

/// Expressions that vanish if the declared angular velocity of a frame in `reference` equals the one that
/// follows from its orientation.
///
/// They are formed in the axes of the frame before the last rotation, in which the equations for the three
/// angles can be solved one after another.
constexpr sequence<expression> orientation_kinematics(const mechanism& m, int place, int reference) {
  symbolic::differentiation along_time = time_derivative(m, m.coordinate_rates);
  vector missing = without_auxiliary_speeds(m).in(m.frames[place].angular_velocity);
  const frame& last = m.frames[place];
  const bool has_rates = !last.rates.empty();
  int axes = place;
  bool turns = false; // whether a rotation has been found
  for (int f = place; f != reference; f = m.frames[f].parent) {
    if (has_rates && f == place) continue;
    vector w = relative_angular_velocity(m, f, along_time);
    if (w.is_zero()) continue;
    if (has_rates || turns)
      w.parts[0].frame = f; // the axis of a rotation has the same components before and after it
    else
      axes = w.parts[0].frame;
    turns = true;
    missing.subtract(w);
  }
  const components left = express(m, missing, axes);
  if (has_rates) return detail::kinematics_of_parameters(last.rates, left, along_time);
  sequence<expression> vanishing;
  for (int i = 0; i < 3; ++i)
    if (!left[i].is_zero()) vanishing.push(left[i]);
  return vanishing;
}

} // namespace kanexpr::mechanics
