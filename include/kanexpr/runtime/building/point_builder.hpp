#pragma once

#include <kanexpr/runtime/building/builder_part.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// The points of a builder.
class point_builder : private builder_part {
public:
  /// A point that is fixed in the inertial frame.
  point_id origin(std::string_view called);
  point_id offset(std::string_view called, point_id parent, const vector& from_parent);
  /// Derives the velocity by the two-point theorem: the point and its parent are both fixed in `frame`.
  void fixed_in(point_id point, frame_id frame);
  /// The position of `point` relative to `from`.
  vector position_of(point_id point, point_id from);
  /// Declares the velocity of a point in `reference`, used in place of the derived one. In the inertial frame
  /// it is the full velocity; in any other frame the motion of the parent, which is fixed there, is added
  /// (one-point theorem).
  void velocity(point_id point, frame_id reference, const vector& value);
  /// The same for a point whose position intentionally does not follow its velocity.
  void velocity_apart_from_position(point_id point, frame_id reference, const vector& value);
  /// Like `velocity`, but always adds the motion of the parent, whatever the frame.
  void velocity_from_parent(point_id point, frame_id reference, const vector& value);

protected:
  explicit point_builder(builder_core& core) : builder_part(core) {}
  ~point_builder() = default;

private:
  bool is_motion_undeclared(point_id p);
  bool may_declare_velocity(point_id point, frame_id reference, const vector& velocity);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/point_builder.ipp>
#endif
