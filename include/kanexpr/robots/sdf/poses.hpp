#pragma once

#include <kanexpr/robots/pose.hpp>

#include <ignition/math/Pose3.hh>
#include <ignition/math/Vector3.hh>

#include <cmath>
#include <numbers>

/// Poses of libsdformat, which have quaternions, as those of robots, which have right angles.
namespace kanexpr::robots::sdf_files {

inline vector3 vector_of(const ignition::math::Vector3d& v) {
  return {v.X() + 0.0, v.Y() + 0.0, v.Z() + 0.0};
}

/// Rounding errors of the way through quaternions are no lengths: what is below a picometre is 0.
inline vector3 place_of(const ignition::math::Vector3d& v, double tolerance) {
  vector3 place = vector_of(v);
  if (tolerance > 0)
    for (double& e : place) e = std::abs(e) < 1e-12 ? 0 : e;
  return place;
}

inline rotation as_it_is(const ignition::math::Quaterniond& q) {
  const double w = q.W(), x = q.X(), y = q.Y(), z = q.Z();
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// By three angles, of which right ones are exact. Near a pitch of 90° these have few digits.
inline rotation turn_of(const ignition::math::Quaterniond& q, double tolerance) {
  const ignition::math::Vector3d angles = q.Euler();
  const double to_pole = std::numbers::pi / 2 - std::abs(angles.Y());
  if (!(tolerance > 0) || (to_pole > tolerance && to_pole < 0.01)) return as_it_is(q);
  return by_roll_pitch_yaw(vector_of(angles), tolerance);
}

inline pose pose_of(const ignition::math::Pose3d& p, double tolerance) {
  return {turn_of(p.Rot(), tolerance), place_of(p.Pos(), tolerance)};
}

} // namespace kanexpr::robots::sdf_files
