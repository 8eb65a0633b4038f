#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// Velocities and accelerations of single points and frames, as vectors in the frames in which they are
/// simplest.
namespace kanexpr::mechanics {

constexpr vector in_working_axes(const motion& k, int frame, const components& value) {
  vector v;
  v.add(k.skeleton_used().working_axes[frame], value);
  return v;
}

/// The velocity of a point in the inertial frame.
constexpr vector velocity_of_point(motion& k, int point) {
  const skeleton& s = k.skeleton_used();
  const int n = s.station_of_point[point];
  return in_working_axes(k, s.stations[n].axes, k.velocity(n));
}

/// The acceleration of a point in the inertial frame.
constexpr vector acceleration_of_point(motion& k, int point) {
  const skeleton& s = k.skeleton_used();
  const int n = s.station_of_point[point];
  return in_working_axes(k, s.stations[n].axes, k.acceleration(n));
}

/// The angular velocity of a frame in the inertial frame.
constexpr vector angular_velocity_of_frame(motion& k, int frame) {
  return in_working_axes(k, frame, k.angular_velocity(frame));
}

/// The angular acceleration of a frame in the inertial frame.
constexpr vector angular_acceleration_of_frame(motion& k, int frame) {
  return in_working_axes(k, frame, k.angular_acceleration(frame));
}

/// The time derivative of a vector in `frame`: the components of each part change, and the part rotates with
/// its own frame.
constexpr vector derivative_in(motion& k, const vector& v, int frame) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  const vector angular_velocity = angular_velocity_of_frame(k, frame);
  vector total;
  for (const vector::part& p : v.parts) {
    const components own{k.rate(k.known(p.value.x)), k.rate(k.known(p.value.y)), k.rate(k.known(p.value.z))};
    components w(*m.g);
    if (s.rigid_with[p.frame] != s.rigid_with[frame]) {
      w = express(m, angular_velocity_of_frame(k, p.frame), p.frame);
      w -= express(m, angular_velocity, p.frame);
    }
    total.add(p.frame, own + cross(w, p.value));
  }
  return total;
}

} // namespace kanexpr::mechanics
