#pragma once

#include <kanexpr/robots/pose.hpp>

#include <ignition/math/Pose3.hh>
#include <ignition/math/Vector3.hh>

#include <cmath>

#include <kanexpr/base/letters_aside.hpp>

/// Converts poses of libsdformat, which use quaternions, to poses of robots, whose right angles are exact.
namespace kanexpr::robots::sdf {

inline vector3 vector_of(const ignition::math::Vector3d& v) {
  return {v.X() + 0.0, v.Y() + 0.0, v.Z() + 0.0};
}

/// The position in a pose. Entries below a picometer, rounding errors of the conversion to quaternions,
/// become 0.
inline vector3 place_of(const ignition::math::Vector3d& v, double tolerance) {
  vector3 place = vector_of(v);
  if (tolerance > 0)
    for (double& e : place) e = std::abs(e) < 1e-12 ? 0 : e;
  return place;
}

inline rotation turn_of(const ignition::math::Quaterniond& q, double tolerance) {
  return with_right_angles(by_quaternion(q.X(), q.Y(), q.Z(), q.W()), tolerance);
}

inline pose pose_of(const ignition::math::Pose3d& p, double tolerance) {
  return {turn_of(p.Rot(), tolerance), place_of(p.Pos(), tolerance)};
}

} // namespace kanexpr::robots::sdf

#include <kanexpr/base/letters_back.hpp>
