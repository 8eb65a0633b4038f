#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// Which motions depend on generalized speeds. A prescribed motion does not, nor do auxiliary speeds count.
namespace kanexpr::mechanics {

namespace detail {

/// Whether a velocity depends on a generalized speed that is not auxiliary.
constexpr bool holds_speed(const skeleton& s, const sequence<partial_velocity>& partials) {
  for (const partial_velocity& p : partials)
    if (p.speed < s.model->speeds.size()) return true;
  return false;
}

/// Whether a frame rotates by generalized speeds.
constexpr bool is_turned_by_speeds(const skeleton& s, int f) {
  for (; f != mechanism::inertial && f != none; f = s.turns_in[f])
    if (holds_speed(s, s.partial_angular_velocities[f])) return true;
  return false;
}

/// Whether a station is moved by generalized speeds. One at rest, or with a prescribed motion, is not.
constexpr bool is_moved_by_speeds(const skeleton& s, int n) {
  for (; n != none; n = s.stations[n].parent) {
    if (holds_speed(s, s.partial_velocities[n]) || is_turned_by_speeds(s, s.stations[n].frame)) return true;
    if (s.stations[n].absolute) return false;
  }
  return false;
}

/// Whether a vector, given in `axes`, has a product with a partial velocity.
constexpr bool meets_any(const skeleton& s, const sequence<partial_velocity>& partials,
                         const components& product) {
  for (const partial_velocity& p : partials)
    if (p.speed < s.model->speeds.size() && !dot(p.value, product).is_zero()) return true;
  return false;
}

/// Whether the rotation of a frame by generalized speeds moves the end of an arm along an axis; both are
/// given in `axes`. The velocity is (ω×r)·a = ω·(r×a).
constexpr bool moves_arm_along(const skeleton& s, int f, int axes, const components& arm,
                               const components& axis) {
  const components moment = cross(arm, axis);
  if (moment.is_zero()) return false;
  for (; f != mechanism::inertial && f != none; f = s.turns_in[f])
    if (meets_any(s, s.partial_angular_velocities[f], express(*s.model, moment, axes, s.working_axes[f])))
      return true;
  return false;
}

/// Whether generalized speeds move the reference point of a flexible body along an axis that is fixed in the
/// body; also true if this is not evident from each rotation and translation between the ground and the body.
constexpr bool is_moved_along(const skeleton& s, const flexible_part& part, const components& axis) {
  if (moves_arm_along(s, part.frame, part.axes, part.offset, axis)) return true;
  for (int n = part.station; n != none; n = s.stations[n].parent) {
    const station& at = s.stations[n];
    if (holds_speed(s, s.partial_velocities[n]) &&
        meets_any(s, s.partial_velocities[n], express(*s.model, axis, part.axes, s.working_axes[at.axes])))
      return true;
    if (at.absolute) return false;
    if (!at.r.is_zero() && moves_arm_along(s, at.frame, at.offset_frame, at.r,
                                           express(*s.model, axis, part.axes, at.offset_frame)))
      return true;
  }
  return false;
}

} // namespace detail

} // namespace kanexpr::mechanics
