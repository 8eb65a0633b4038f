#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/body_reader.hpp>
#include <kanexpr/derivation/read/kinematics_reader.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/rotor.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

using describe::joint_record;

/// Reads the contributions of joints to a model, except for their symbols, which follow those of the model's
/// lists.
class joint_reader : part_reader {
public:
  constexpr joint_reader(const part_reader& parts, body_reader& bodies, kinematics_reader& kinematics)
      : part_reader(parts), bodies_(bodies), kinematics_(kinematics) {}

  /// Checks all joints; called before any part of them is read.
  constexpr void check_all() {
    for (int i = 0; i < reading_.from.joints.size && !reading_.mistake; ++i) {
      const joint_record& r = reading_.from.joints[i];
      check_joint(r);
      for (int j = 0; j < i; ++j)
        if (&reading_.from.joints[j] == &r)
          reading_.fail({"joint ", r.called, " is listed twice"});
        else if (reading_.from.joints[j].called == r.called)
          reading_.fail({"two joints are called ", r.called});
    }
    for (const describe::reaction_record& r : reading_.from.reactions)
      if (!reading_.mistake) check_reaction(r);
  }

  /// Reads a joint and its body, which are part of the system even if nothing else mentions them. Joints that
  /// contribute neither motion nor mass are an exception, because their points would only be additional
  /// candidates for reference points.
  constexpr void read(const joint_record& r) {
    check_axes(r);
    if (!reading_.mistake && r.place.kind != shape::nothing) check_place(r);
    if (r.speeds.size == 0 && r.body == nullptr) return;
    if (!reading_.mistake) entities_.frame(r.frame, "joints<...>"sv);
    if (!reading_.mistake) entities_.point(r.point, "joints<...>"sv);
    if (!reading_.mistake && r.body != nullptr) bodies_.read(*r.body);
    if (reading_.mistake || r.rotor == nullptr) return;
    if (add_rotor(r, r.rotor, r.has_gear_ratio, "_rotor")) return;
    if (!reading_.mistake)
      reading_.fail({"joint ", r.called, " has a rotor whose inertia or gear ratio is zero"});
  }

  /// Reads the rotors of motors.
  constexpr void read_motors() {
    for (const load_record& r : reading_.from.loads)
      if (r.rotor != nullptr && !reading_.mistake) add_rotor(*r.joint, r.rotor, true, "_motor");
  }

  constexpr void read_kinematics() {
    for (const joint_record& r : reading_.from.joints)
      for (const phrase& equation : r.kinematics)
        if (!reading_.mistake) kinematics_.read(equation);
  }

private:
  constexpr void check_joint(const joint_record& r) {
    if (r.unparsed) return reading_.fail_by_unparsed(r.called, "joints<...>"sv);
    if (!reading_.check_base_conflict(r.conflict, r.called)) return;
    if (r.declared_name.empty())
      return reading_.fail({"joints<...> lists ", short_name(r.called).view(), ", which is ",
                            r.instead.empty() ? "not a joint" : r.instead});
    if (r.called != r.declared_name) return reading_.fail_by_self("joint", r.called, r.declared_name);
    if (!r.mistake.empty())
      return reading_.fail({"joint ", r.called, " ", r.mistake, r.form.empty() ? "" : "; write ", r.form});
    if (r.parent_frame->declared_name.empty())
      check_parent(r, r.parent_frame->called, r.parent_frame->instead);
    else if (r.parent_point->declared_name.empty())
      check_parent(r, r.parent_point->called, r.parent_point->instead);
  }

  constexpr void check_parent(const joint_record& r, std::string_view parent, std::string_view instead) {
    if (instead.empty())
      return reading_.fail({"joint ", r.called, " is attached to ", short_name(parent).view(),
                            ", which is not a joint, or is defined later"});
    reading_.fail({"joint ", r.called, " is attached to ", parent, ", which is ", instead,
                   instead == describe::a_beam ? "" : "; write frame_and_point<frame, point>"});
  }

  constexpr void check_axes(const joint_record& r) {
    sequence<mechanics::components> axes;
    for (const phrase& p : r.axes) {
      const mechanics::vector given = phrases_.vector_of(p, {"the axis of joint "sv, r.called}, r.called);
      const int home = entities_.frame(r.home, r.called);
      if (reading_.mistake) return;
      axes.push(mechanics::express(reading_.into.mechanism, given, home));
      if (axes.back().is_zero()) return reading_.fail({"joint ", r.called, " has an axis of zero length"});
      if (!mechanics::is_fixed(axes.back()))
        return reading_.fail(
            {"joint ", r.called, " has an axis that is not fixed in ", r.parent_frame->called});
    }
    if (axes.size() == 2 && cross(axes[0], axes[1]).is_zero())
      reading_.fail({"joint ", r.called, " has two parallel axes"});
  }

  /// Checks that the location of a joint rotates with its parent.
  constexpr void check_place(const joint_record& r) {
    const mechanics::vector given =
        phrases_.vector_of(r.place, {"the position of joint "sv, r.called}, r.called);
    const int parent = entities_.frame(r.parent_frame, r.called);
    if (!reading_.mistake && !mechanics::is_along_still_axes(reading_.into.mechanism, given, parent))
      reading_.fail(
          {"joint ", r.called, " is placed along axes that are not fixed in ", r.parent_frame->called});
  }

  /// Adds a rotor that turns with a joint, and returns whether it has an inertia.
  constexpr bool add_rotor(const joint_record& r, const phrase* rotor, bool has_gear_ratio,
                           std::string_view suffix) {
    const expression inertia =
        phrases_.scalar_of(rotor[0], {"the rotor inertia of joint ", r.called}, r.called);
    expression angle = phrases_.scalar_of(r.coordinates[0], {"the coordinate of joint ", r.called}, r.called);
    expression ratio = m_.one();
    if (has_gear_ratio)
      ratio = phrases_.scalar_of(rotor[1], {"the gear ratio of joint ", r.called}, r.called);
    if (reading_.mistake) return false;
    if (!mechanics::is_fixed(inertia) || !mechanics::is_fixed(ratio)) {
      reading_.fail(
          {mechanics::is_fixed(inertia) ? "the gear ratio of joint " : "the rotor inertia of joint ",
           r.called, " changes; it may contain only numbers and parameters"});
      return false;
    }
    angle = ratio * angle;
    const int point = entities_.point(r.parent_point, r.called);
    if (inertia.is_zero() || angle.is_zero()) return false;
    base::name called(r.called);
    called.append(suffix);
    mechanics::add_rotor(m_, called, mechanics::origin_of(m_, point), angle, inertia);
    return true;
  }

  constexpr void check_reaction(const describe::reaction_record& r) {
    if (r.joint == nullptr)
      return reading_.fail(
          {"reactions are requested for ", short_name(r.called).view(), ", which is not a joint"});
    for (const joint_record& listed : reading_.from.joints)
      if (&listed == r.joint) return;
    reading_.fail({"reactions are requested for joint ", r.called, ", which is not listed in joints<...>"});
  }

  body_reader& bodies_;
  kinematics_reader& kinematics_;
};

} // namespace kanexpr::derivation
