#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// The frames of a builder.
class frame_builder : private builder_part {
public:
  static constexpr frame_id inertial_frame() { return frame_id{mechanics::mechanism::inertial}; }

  /// A frame rotated by `angle` about an axis that is fixed in the parent.
  frame_id rotated(std::string_view called, frame_id parent, expression angle, const vector& axis);
  frame_id body_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                      expression second, expression third) {
    return rotated_by_sequence(called, parent, letters, {first, second, third}, false);
  }
  frame_id space_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                       expression second, expression third) {
    return rotated_by_sequence(called, parent, letters, {first, second, third}, true);
  }
  /// A frame rotated by the unit quaternion e0 + e1 i + e2 j + e3 k.
  frame_id quaternion(std::string_view called, frame_id parent, expression e0, expression e1, expression e2,
                      expression e3);
  /// A frame rotated by φ about the unit vector a; the modified Rodrigues parameters are the components of a
  /// tan(φ/4).
  frame_id modified_rodrigues(std::string_view called, frame_id parent, expression s1, expression s2,
                              expression s3);
  /// A frame specified by its direction cosines: v in the parent's axes = to_parent · v in the frame's axes.
  frame_id direction_cosines(std::string_view called, frame_id parent, const mechanics::matrix3& to_parent);
  /// Declares the angular velocity of a frame in `reference`, used in place of the derived one. It must agree
  /// with the orientation, except for a spin about an axis whose angle the orientation omits.
  void angular_velocity(frame_id frame, frame_id reference, const vector& value) {
    declare_angular_velocity(frame, reference, value, false);
  }
  /// The same for a frame whose orientation intentionally does not follow its angular velocity.
  void angular_velocity_apart_from_orientation(frame_id frame, frame_id reference, const vector& value) {
    declare_angular_velocity(frame, reference, value, true);
  }

protected:
  explicit frame_builder(builder_core& core) : builder_part(core) {}
  ~frame_builder() = default;

private:
  template <class... Arguments>
  bool is_new_frame(std::string_view called, frame_id parent, const Arguments&... orientation) {
    return checks_.is_new("frames", called, m_.frames) && checks_.owns(called, parent, orientation...);
  }
  frame_id rotated_by_sequence(std::string_view called, frame_id parent, std::string_view letters,
                               const base::sequence<expression>& angles, bool space_fixed);
  void declare_angular_velocity(frame_id frame, frame_id reference, const vector& value, bool apart);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/frame_builder.ipp>
#endif
