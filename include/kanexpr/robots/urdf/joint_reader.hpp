#pragma once

#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kanexpr::robots::urdf {

using index_by_name = std::unordered_map<std::string, int>;

inline std::optional<joint_kind> joint_kind_of(std::string_view type) {
  constexpr std::pair<std::string_view, joint_kind> kinds[]{
      {"fixed", joint_kind::fixed},           {"revolute", joint_kind::revolute},
      {"continuous", joint_kind::continuous}, {"prismatic", joint_kind::prismatic},
      {"planar", joint_kind::planar},         {"floating", joint_kind::floating}};
  for (const auto& [called, kind] : kinds)
    if (called == type) return kind;
  return {};
}

/// Reads joints, their mimics and their transmissions after all links have been read.
class joint_reader {
public:
  joint_reader(document& from, const index_by_name& links, robot& into)
      : from_(from), links_(links), into_(into) {}

  bool read(const element& e) {
    const auto name = from_.text(e, "name", "a joint");
    if (!name) return false;
    joint read;
    read.name = *name;
    const std::string whose = "joint " + printable(read.name);
    if (!joint_indices_.emplace(read.name, static_cast<int>(into_.joints.size())).second)
      return from_.fail(e, "two joints are called " + printable(read.name));
    const auto type = from_.text(e, "type", whose);
    if (!type) return false;
    const auto kind = joint_kind_of(*type);
    if (!kind)
      return from_.fail(e, whose + " has type " + printable(*type) +
                               "; expected fixed, revolute, continuous, prismatic, planar or floating");
    read.kind = *kind;
    from_.note_unknown_elements(e,
                                {"origin", "parent", "child", "axis", "calibration", "dynamics", "limit",
                                 "mimic", "safety_controller"},
                                whose);
    if (!read_link_name(e, "parent", whose, read.parent) || !read_link_name(e, "child", whose, read.child) ||
        !from_.read_origin(e, read.origin, whose) || !read_axis(e, whose, read) ||
        !read_limits(e, whose, read) || !read_dynamics(e, whose, read))
      return false;
    if (read.parent == read.child) return from_.fail(e, whose + " connects a link to itself");
    if (const element* mimic = from_.single_child(e, "mimic", whose))
      mimics_.emplace_back(into_.joints.size(), mimic);
    into_.joints.push_back(std::move(read));
    lines_.push_back(e.GetLineNum());
    return true;
  }

  bool read_mimics() {
    for (const auto& [index, e] : mimics_)
      if (!read_mimic(*e, into_.joints[index])) return false;
    std::vector<std::pair<std::size_t, double>> held; // joints that are held by a fixed leader
    for (const auto& [index, e] : mimics_) {
      const joint& follower = into_.joints[index];
      if (mimics_itself(follower))
        return from_.fail(*e, "joint " + printable(follower.name) + " mimics a joint that in turn mimics it");
      const mimic_rule rule = resolved_mimic(into_, static_cast<int>(index));
      const joint& leader = entry(into_.joints, rule.leader);
      if (leader.kind != joint_kind::fixed || &leader == &follower) continue;
      from_.note(*e, "joint " + printable(follower.name) + " mimics " + printable(leader.name) +
                         ", which is fixed, so it is fixed too");
      held.emplace_back(index, rule.offset);
    }
    for (const auto& [index, q] : held) fix(into_.joints[index], q);
    return true;
  }

  /// Reads the gear and the rotor of a joint.
  bool read_transmission(const element& e) {
    for (const element* j : children(e, "joint")) {
      const char* const name = j->Attribute("name");
      const auto found = joint_indices_.find(name ? name : "");
      if (found == joint_indices_.end()) {
        from_.note(*j, "a transmission refers to joint " + printable(name ? name : "") +
                           ", which does not exist; it is ignored");
        continue;
      }
      joint& of = entry(into_.joints, found->second);
      const std::string whose = "the transmission of joint " + printable(of.name);
      drive read;
      if (!read_gear(e, whose, read) || !read_gear(*j, whose, read)) return false;
      for (const element* a : children(e, "actuator"))
        if (!read_gear(*a, whose, read)) return false;
      store_gear(e, read, whose, of);
    }
    return true;
  }

  int line_of(int joint) const { return entry(lines_, joint); }

private:
  bool read_link_name(const element& e, const char* which, const std::string& whose, int& into) {
    const element* const found = from_.single_child(e, which, whose);
    if (!found) return from_.fail(e, whose + " has no " + which);
    const auto name = from_.text(*found, "link", std::string("the ") + which + " of " + whose);
    if (!name) return false;
    const auto at = links_.find(*name);
    if (at == links_.end())
      return from_.fail(*found,
                        whose + " has the " + which + " " + printable(*name) + ", which is not a link");
    into = at->second;
    return true;
  }

  bool read_axis(const element& e, const std::string& whose, joint& into) {
    const element* const axis = from_.single_child(e, "axis", whose);
    if (!axis || !has_axis(into.kind)) return true;
    from_.note_unknown_attributes(*axis, {"xyz"}, "the axis of " + whose);
    if (!from_.read(*axis, "xyz", into.axis, "the axis of " + whose)) return false;
    into.axis = direction_of(into.axis, from_.tolerance());
    return !is_zero(into.axis) || from_.fail(*axis, "the axis of " + whose + " has zero length");
  }

  bool read_limits(const element& e, const std::string& whose, joint& into) {
    const element* const limit = from_.single_child(e, "limit", whose);
    if (!limit) return true;
    const std::string of = "the limit of " + whose;
    joint_limits& read = into.limits;
    if (!from_.read(*limit, "effort", read.effort, of) || !from_.read(*limit, "velocity", read.velocity, of))
      return false;
    if (into.kind != joint_kind::revolute && into.kind != joint_kind::prismatic) return true;
    read.lower = read.upper = 0; // the defaults of URDF
    if (!from_.read(*limit, "lower", read.lower, of) || !from_.read(*limit, "upper", read.upper, of))
      return false;
    if (read.lower > read.upper) from_.note(*limit, whose + " has a lower limit above its upper limit");
    return true;
  }

  bool read_dynamics(const element& e, const std::string& whose, joint& into) {
    const element* const dynamics = from_.single_child(e, "dynamics", whose);
    if (!dynamics) return true;
    from_.note_unknown_attributes(*dynamics, {"damping", "friction"}, "the dynamics of " + whose);
    if (!from_.read(*dynamics, "damping", into.damping, whose) ||
        !from_.read(*dynamics, "friction", into.friction, whose))
      return false;
    if (into.damping < 0) return from_.fail(*dynamics, "the damping of " + whose + " is negative");
    if (into.friction < 0) return from_.fail(*dynamics, "the friction of " + whose + " is negative");
    const bool is_felt = into.kind == joint_kind::fixed || has_one_coordinate(into.kind);
    if (!is_felt && (into.damping > 0 || into.friction > 0))
      from_.note(*dynamics,
                 "the dynamics of " + whose + " are ignored because it has more than one coordinate");
    return true;
  }

  bool read_mimic(const element& e, joint& into) {
    const std::string whose = "joint " + printable(into.name);
    if (into.kind == joint_kind::fixed) { // programs that make a joint fixed do not remove its mimic element
      from_.note(e, whose + " is fixed, so its mimic is ignored");
      return true;
    }
    const auto name = from_.text(e, "joint", "the mimic of " + whose);
    if (!name) return false;
    from_.note_unknown_attributes(e, {"joint", "multiplier", "offset"}, "the mimic of " + whose);
    mimic_rule read;
    if (!from_.read(e, "multiplier", read.multiplier, "the mimic of " + whose) ||
        !from_.read(e, "offset", read.offset, "the mimic of " + whose))
      return false;
    const auto at = joint_indices_.find(*name);
    if (at == joint_indices_.end())
      return from_.fail(e, whose + " mimics " + printable(*name) + ", which is not a joint");
    read.leader = at->second;
    if (!has_one_coordinate(into.kind))
      return from_.fail(e, whose + " mimics another joint but has more than one coordinate");
    const joint_kind leader = entry(into_.joints, read.leader).kind;
    if (leader != joint_kind::fixed && !has_one_coordinate(leader))
      return from_.fail(e, whose + " mimics " + printable(*name) + ", which has more than one coordinate");
    into.mimic = read;
    return true;
  }

  /// Whether the chain of leaders of a joint contains a loop.
  bool mimics_itself(const joint& follower) const {
    const joint* at = &follower;
    for (std::size_t steps = 0; at->mimic; ++steps) {
      if (steps == mimics_.size()) return true;
      at = &entry(into_.joints, at->mimic->leader);
    }
    return false;
  }

  /// Fixes a joint at the position q.
  void fix(joint& j, double q) {
    if (j.kind == joint_kind::prismatic)
      j.origin = product(j.origin, pose{no_rotation, {q * j.axis[0], q * j.axis[1], q * j.axis[2]}});
    else
      j.origin = product(j.origin, pose{rotation_about(j.axis, q, from_.tolerance()), {}});
    j.kind = joint_kind::fixed;
    j.mimic.reset();
  }

  /// The gear ratio and the rotor inertia of a joint, as read from a transmission.
  struct drive {
    std::optional<double> gear_ratio{}, rotor_inertia{};
    bool is_single = true; ///< whether there is only one gear and one rotor
  };

  /// Reads the elements of ROS or of Drake.
  bool read_gear(const element& in, const std::string& whose, drive& into) {
    for (const element* e : children(in)) {
      const std::string_view is = e->Name();
      const bool gear = is == "mechanicalReduction" || is == "drake:gear_ratio";
      if (!gear && is != "rotorInertia" && is != "drake:rotor_inertia") continue;
      const char* text = e->Attribute("value");
      if (!text) text = e->GetText();
      std::string_view words = text ? text : "";
      const auto value = number_in(next_word(words));
      if (!value || !next_word(words).empty())
        return from_.fail(*e, "the " + printable(is) + " of " + whose + " is not a finite number");
      if (!gear && *value < 0) return from_.fail(*e, "the rotor inertia of " + whose + " is negative");
      if (gear && !(std::abs(*value) > 0))
        return from_.fail(*e, "the " + printable(is) + " of " + whose + " is 0");
      std::optional<double>& known = gear ? into.gear_ratio : into.rotor_inertia;
      into.is_single = into.is_single && (!known || (gear && std::abs(*known - *value) <= 0));
      known = value;
    }
    return true;
  }

  /// A rotor contributes n² J at its joint if it is the only rotor and drives only that joint.
  void store_gear(const element& e, const drive& read, const std::string& whose, joint& into) {
    const bool is_alone = read.is_single && !e.FirstChildElement("joint")->NextSiblingElement("joint");
    const char* const why = !is_alone                ? "the transmission has several rotors, gears or joints"
                            : into.rotor_inertia > 0 ? "the joint already has one"
                            : !has_one_coordinate(into.kind)
                                ? "the joint does not have exactly one coordinate"
                                : nullptr;
    if (why && read.rotor_inertia > 0.0)
      return from_.note(e, "the rotor in " + whose + " is ignored because " + why);
    into.gear_ratio = read.gear_ratio.value_or(into.gear_ratio);
    into.rotor_inertia = read.rotor_inertia.value_or(into.rotor_inertia);
  }

  document& from_;
  const index_by_name& links_;
  robot& into_;
  index_by_name joint_indices_{};
  std::vector<std::pair<std::size_t, const element*>> mimics_{};
  std::vector<int> lines_{};
};

} // namespace kanexpr::robots::urdf
