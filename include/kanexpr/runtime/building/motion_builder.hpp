#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

/// The velocities and accelerations of a builder, for its loads and constraints. After frames and points have
/// been defined, `mechanics::known_motion known(b.mechanism());` provides them.
class motion_builder : private builder_part {
public:
  /// The velocity of a point in the inertial frame.
  vector velocity_of(point_id point, mechanics::known_motion& known);
  /// The acceleration of a point in the inertial frame, with the rates of the speeds as symbols.
  vector acceleration_of(point_id point, mechanics::known_motion& known);
  /// The angular velocity of a frame in the inertial frame.
  vector angular_velocity_of(frame_id frame, mechanics::known_motion& known);
  /// The angular acceleration of a frame in the inertial frame, with the rates of the speeds as symbols.
  vector angular_acceleration_of(frame_id frame, mechanics::known_motion& known);
  /// The time derivative of a scalar.
  expression derivative(expression e, mechanics::known_motion& known);
  /// The time derivative of a vector in a frame.
  vector derivative_in(const vector& v, frame_id frame, mechanics::known_motion& known);

protected:
  explicit motion_builder(builder_core& core) : builder_part(core) {}
  ~motion_builder() = default;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/motion_builder.ipp>
#endif
