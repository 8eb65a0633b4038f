#pragma once

#include <kanexpr/derivation/read/reading.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Whether an entity is `other` or one of its descendants.
template <class Record>
constexpr bool is_given_from(const Record& given, const Record* other) {
  const Record* r = &given;
  while (r != other && r != nullptr) r = r->parent;
  return r == other;
}

/// The joints of a system whose reactions are requested: auxiliary speeds move their frames and points, and
/// everything attached to them.
class freed_joints {
public:
  constexpr explicit freed_joints(reading& all) : reading_(all) {}

  /// Returns the record of a frame; the frame of such a joint also moves with auxiliary speeds.
  constexpr const frame_record* record_of(const frame_record* r) const {
    for (const describe::reaction_record& joint : freed())
      if (joint.frame == r) return joint.freed_frame;
    return r;
  }
  constexpr const point_record* record_of(const point_record* r) const {
    for (const describe::reaction_record& joint : freed())
      if (joint.point == r) return joint.freed_point;
    return r;
  }

  /// The frame of the joint to which a point is attached: auxiliary speeds rotate this frame and everything
  /// fixed in it, regardless of the axes in which the point was given. Null if there are no such joints.
  constexpr const frame_record* frame_below(const point_record& r) const {
    if (freed().size == 0) return nullptr;
    for (const point_record* p = r.parent; p != nullptr; p = p->parent)
      for (const describe::joint_record& joint : reading_.from.joints)
        if (joint.point == p) return joint.frame;
    return nullptr;
  }

  /// Reports a motion declared relative to a frame on the other side of such a joint, because it would not
  /// contain the auxiliary speeds.
  constexpr void check_reference(const frame_record& r) const {
    for (const describe::reaction_record& joint : freed())
      if (is_given_from(*r.parent, joint.frame) && !is_given_from(*r.reference, joint.frame))
        fail_across(joint, "the angular velocity of frame ", r.called, *r.reference);
  }
  /// The same for a velocity in the inertial frame.
  constexpr void check_reference(const point_record& r) const {
    for (const describe::reaction_record& joint : freed())
      if (is_given_from(*r.parent, joint.point))
        fail_across(joint, "the velocity of point ", r.called, *r.reference);
  }

private:
  constexpr const describe::listing<describe::reaction_record>& freed() const {
    return reading_.from.reactions;
  }

  constexpr void fail_across(const describe::reaction_record& joint, std::string_view what,
                             std::string_view called, const frame_record& reference) const {
    reading_.fail({what, called, " is declared in ", reference.called, ", across joint ", joint.called,
                   ", whose reactions are requested; declare it in ", joint.called});
  }

  reading& reading_;
};

} // namespace kanexpr::derivation
