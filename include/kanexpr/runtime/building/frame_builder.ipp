#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/runtime/building/frame_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE frame_id frame_builder::rotated(std::string_view called, frame_id parent, expression angle,
                                               const vector& axis) {
  if (!is_new_frame(called, parent, angle, axis)) return {};
  const mechanics::components a = mechanics::express(m_, axis, place(parent));
  if (a.is_zero())
    checks_.fail({"frame ", called, " is rotated about an axis of zero length"});
  else if (!mechanics::is_fixed(a))
    checks_.fail({"frame ", called, " is rotated about an axis that is not fixed in ", name_of(parent)});
  else
    return frame_id{mechanics::add_rotated_frame(m_, called, place(parent), angle, a)};
  return {};
}

KANEXPR_ENGINE frame_id frame_builder::rotated_by_sequence(std::string_view called, frame_id parent,
                                                           std::string_view letters,
                                                           const base::sequence<expression>& angles,
                                                           bool space_fixed) {
  if (!is_new_frame(called, parent, angles)) return {};
  if (!mechanics::is_sequence(letters)) {
    checks_.fail({"frame ", called, " is rotated by the sequence ", letters,
                  ", which is invalid; use three axes, no two consecutive ones equal"});
    return {};
  }
  return frame_id{mechanics::add_frame_by_sequence(m_, called, place(parent), letters, angles, space_fixed)};
}

KANEXPR_ENGINE frame_id frame_builder::quaternion(std::string_view called, frame_id parent, expression e0,
                                                  expression e1, expression e2, expression e3) {
  if (!is_new_frame(called, parent, e0, e1, e2, e3)) return {};
  return frame_id{mechanics::add_frame_by_quaternion(m_, called, place(parent), e0, e1, e2, e3)};
}

KANEXPR_ENGINE frame_id frame_builder::modified_rodrigues(std::string_view called, frame_id parent,
                                                          expression s1, expression s2, expression s3) {
  if (!is_new_frame(called, parent, s1, s2, s3)) return {};
  return frame_id{mechanics::add_frame_by_modified_rodrigues(m_, called, place(parent), {s1, s2, s3})};
}

KANEXPR_ENGINE frame_id frame_builder::direction_cosines(std::string_view called, frame_id parent,
                                                         const mechanics::matrix3& to_parent) {
  if (!is_new_frame(called, parent, to_parent)) return {};
  return frame_id{mechanics::add_frame_by_matrix(m_, called, place(parent), to_parent)};
}

KANEXPR_ENGINE void frame_builder::declare_angular_velocity(frame_id frame, frame_id reference,
                                                            const vector& value, bool apart) {
  if (!checks_.owns("a declared angular velocity", frame, reference)) return;
  if (frame == inertial_frame())
    checks_.fail({"the inertial frame ", name_of(frame), " has a declared angular velocity"});
  else if (m_.frames[place(frame)].has_declared_angular_velocity())
    checks_.fail({"frame ", name_of(frame), " has two declared angular velocities"});
  else if (checks_.owns(name_of(frame), value))
    m_.frames[place(frame)].declare_angular_velocity(place(reference), value, apart);
}

} // namespace kanexpr::runtime
