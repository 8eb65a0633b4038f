// Joint reactions from the Newton-Euler equations of the bodies that the joints carry.
#pragma once

#include "describe/joints/by_hand.hpp"

#include <kanexpr/symbolic.hpp>

#include <Eigen/Geometry>

#include <array>

namespace by_hand {

using Eigen::Matrix3d, Eigen::Vector3d;

template <class Link>
struct Center : offset<Center<Link>, Link, center_of<Link>> {};

/// Vectors of a model, evaluated by the interpreter.
template <class System, auto... vectors, class... Arguments>
std::array<Vector3d, sizeof...(vectors)> seen(const Arguments&... at) {
  static auto model = derive<System>();
  return {[&] { return Vector3d(model.function(model.template get<vectors>())(at...)); }()...};
}

/// The force and the torque, about the inertial origin, that produce a link's motion, minus its weight.
struct wrench {
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
};

template <class System, class Link, class... Arguments>
wrench needed_by(const Arguments&... at) {
  const auto [axis_x, axis_y, axis_z, c, a, w, alpha] =
      seen<System, Link::x, Link::y, Link::z, position_of<Center<Link>, Ground>,
           acceleration_of<Center<Link>>, angular_velocity_of<Link>, angular_acceleration_of<Link>>(at...);
  const Matrix3d R = (Matrix3d() << axis_x, axis_y, axis_z).finished();
  const Matrix3d own_inertia = (Matrix3d() << 0.4, 0.01, 0.03, 0.01, 0.5, -0.02, 0.03, -0.02, 0.6).finished();
  const Matrix3d I = R * own_inertia * R.transpose();
  wrench all;
  all.force = 2.5 * (a - Vector3d(1.2, 0.7, -9.81));
  all.torque = I * alpha + w.cross(I * w) + c.cross(all.force);
  return all;
}

/// The load on a link at its joint, in the axes of the link: it produces the motion of the link and of
/// everything attached to it.
template <class System, class Link, class Seat, class... Outward, class... Arguments>
wrench needed_at(const Arguments&... at) {
  wrench all;
  const auto add = [&](const wrench& one) { all.force += one.force, all.torque += one.torque; };
  add(needed_by<System, Link>(at...));
  (add(needed_by<System, Outward>(at...)), ...);
  const auto [sits_at, axis_x, axis_y, axis_z] =
      seen<System, position_of<Seat, Ground>, Link::x, Link::y, Link::z>(at...);
  const Matrix3d R = (Matrix3d() << axis_x, axis_y, axis_z).finished();
  return {R.transpose() * all.force, R.transpose() * (all.torque - sits_at.cross(all.force))};
}

template <class System, class Link, class Seat, class... Outward, class... Arguments>
void expect_newton_and_euler(const Vector3d& applied, const Arguments&... at) {
  const wrench all = needed_at<System, Link, Seat, Outward...>(at...);
  const auto found = reactions_of<System, Link>(at...);
  EXPECT_LT((found.force - all.force).norm(), 1e-11);
  EXPECT_LT((found.torque - (all.torque - applied)).norm(), 1e-11);
  EXPECT_TRUE(found.status);
}

} // namespace by_hand
