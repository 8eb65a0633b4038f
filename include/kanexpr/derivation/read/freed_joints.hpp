#pragma once

#include <kanexpr/derivation/read/reading.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Whether an entity is `other` or is given relative to it, directly or through its ancestors.
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
    for (int i = 0; i < size(); ++i)
      if (freed(i).frame == r) return freed(i).freed_frame;
    return r;
  }
  constexpr const point_record* record_of(const point_record* r) const {
    for (int i = 0; i < size(); ++i)
      if (freed(i).point == r) return freed(i).freed_point;
    return r;
  }

  /// The frame of the joint to which a point is attached: auxiliary speeds rotate this frame and everything
  /// fixed in it, regardless of the axes in which it was given. Null if there are no such joints.
  constexpr const frame_record* frame_below(const point_record& r) const {
    if (size() == 0) return nullptr;
    const describe::listing<describe::joint_record>& joints = reading_.from.joints;
    for (const point_record* p = r.parent; p != nullptr; p = p->parent)
      for (int i = 0; i < joints.size; ++i)
        if (joints[i].point == p) return joints[i].frame;
    return nullptr;
  }

  /// Reports a motion declared relative to a frame on the other side of such a joint, because it would not
  /// contain the auxiliary speeds.
  constexpr void check_is_held(const frame_record& r) const {
    for (int i = 0; i < size(); ++i)
      if (is_given_from(*r.parent, freed(i).frame) && !is_given_from(*r.reference, freed(i).frame))
        fail_past(freed(i), "the angular velocity of frame ", r.called, *r.reference);
  }
  /// The same for a velocity in the inertial frame.
  constexpr void check_is_held(const point_record& r) const {
    for (int i = 0; i < size(); ++i)
      if (is_given_from(*r.parent, freed(i).point))
        fail_past(freed(i), "the velocity of point ", r.called, *r.reference);
  }

private:
  constexpr int size() const { return reading_.from.reactions.size; }
  constexpr const describe::reaction_record& freed(int i) const { return reading_.from.reactions[i]; }

  constexpr void fail_past(const describe::reaction_record& joint, std::string_view what,
                           std::string_view called, const frame_record& reference) const {
    reading_.fail({what, called, " is declared in ", reference.called, ", across joint ", joint.called,
                   ", whose reactions are requested; declare it in ", joint.called});
  }

  reading& reading_;
};

} // namespace kanexpr::derivation
