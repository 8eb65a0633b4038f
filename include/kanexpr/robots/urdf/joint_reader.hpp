#pragma once

#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <algorithm>
#include <unordered_map>

namespace kanexpr::robots::urdf {

/// The places of what has a name.
using places = std::unordered_map<std::string, int>;

inline std::optional<joint_kind> joint_kind_of(std::string_view type) {
  constexpr std::pair<std::string_view, joint_kind> kinds[]{
      {"fixed", joint_kind::fixed},           {"revolute", joint_kind::revolute},
      {"continuous", joint_kind::continuous}, {"prismatic", joint_kind::prismatic},
      {"planar", joint_kind::planar},         {"floating", joint_kind::floating}};
  for (const auto& [called, kind] : kinds)
    if (called == type) return kind;
  return {};
}

/// Joints, and what speaks of them, once all links are there.
class joint_reader {
public:
  joint_reader(document& from, const places& links, robot& into) : from_(from), links_(links), into_(into) {}

  bool read(const element& e) {
    const auto name = from_.text(e, "name", "a joint");
    if (!name) return false;
    joint read;
    read.name = *name;
    const std::string whose = "joint " + shown(read.name);
    if (!places_.emplace(read.name, static_cast<int>(into_.joints.size())).second)
      return from_.fail(e, "two joints are called " + shown(read.name));
    const auto type = from_.text(e, "type", whose);
    if (!type) return false;
    const auto kind = joint_kind_of(*type);
    if (!kind)
      return from_.fail(e, whose + " has the type " + shown(*type) +
                               ", which is not fixed, revolute, continuous, prismatic, planar or floating");
    read.is = *kind;
    if (!take_link(e, "parent", whose, read.parent) || !take_link(e, "child", whose, read.child) ||
        !from_.take_origin(e, read.origin, whose) || !take_axis(e, whose, read) ||
        !take_limits(e, whose, read) || !take_dynamics(e, whose, read))
      return false;
    if (read.parent == read.child) return from_.fail(e, whose + " leads from a link to itself");
    if (const element* mimic = e.FirstChildElement("mimic")) mimics_.emplace_back(into_.joints.size(), mimic);
    into_.joints.push_back(std::move(read));
    lines_.push_back(e.GetLineNum());
    return true;
  }

  bool read_mimics() {
    for (const auto& [place, e] : mimics_)
      if (!take_mimic(*e, into_.joints[place])) return false;
    std::vector<std::pair<std::size_t, double>> held; // by a joint that is fixed
    for (const auto& [place, e] : mimics_) {
      double multiplier = 1, offset = 0;
      const joint* at = &into_.joints[place];
      for (std::size_t steps = 0; at->mimic; ++steps) {
        if (steps == mimics_.size())
          return from_.fail(*e, "joint " + shown(into_.joints[place].name) +
                                    " follows a joint that follows it in turn");
        offset += multiplier * at->mimic->offset;
        multiplier *= at->mimic->multiplier;
        at = &into_.joints[static_cast<std::size_t>(at->mimic->leader)];
      }
      if (at->is != joint_kind::fixed || at == &into_.joints[place]) continue;
      from_.note(*e, "joint " + shown(into_.joints[place].name) + " follows " + shown(at->name) +
                         ", which is fixed, and is fixed too");
      held.emplace_back(place, offset);
    }
    for (const auto& [place, q] : held) fix(into_.joints[place], q);
    return true;
  }

  /// The gear and the rotor behind a joint.
  bool read_transmission(const element& e) {
    for (const element* j = e.FirstChildElement("joint"); j; j = j->NextSiblingElement("joint")) {
      const char* const name = j->Attribute("name");
      const auto found = places_.find(name ? name : "");
      if (found == places_.end()) {
        from_.note(*j, "a transmission speaks of the joint " + shown(name ? name : "") +
                           ", which is not there, and is left out");
        continue;
      }
      joint& of = into_.joints[static_cast<std::size_t>(found->second)];
      const std::string whose = "the transmission of joint " + shown(of.name);
      if (!take_gear(e, whose, of) || !take_gear(*j, whose, of)) return false;
      for (const element* a = e.FirstChildElement("actuator"); a; a = a->NextSiblingElement("actuator"))
        if (!take_gear(*a, whose, of)) return false;
    }
    return true;
  }

  int line_of(int joint) const { return lines_[static_cast<std::size_t>(joint)]; }

private:
  bool take_link(const element& e, const char* which, const std::string& whose, int& into) {
    const element* const found = e.FirstChildElement(which);
    if (!found) return from_.fail(e, whose + " has no " + which);
    const auto name = from_.text(*found, "link", std::string("the ") + which + " of " + whose);
    if (!name) return false;
    const auto at = links_.find(*name);
    if (at == links_.end())
      return from_.fail(*found, whose + " has the " + which + " " + shown(*name) + ", which is no link");
    into = at->second;
    return true;
  }

  bool take_axis(const element& e, const std::string& whose, joint& into) {
    const element* const axis = e.FirstChildElement("axis");
    if (!axis || !has_axis(into.is)) return true;
    if (!from_.take(*axis, "xyz", into.axis, "the axis of " + whose)) return false;
    into.axis = direction_of(into.axis, from_.tolerance());
    return !is_zero(into.axis) || from_.fail(*axis, "the axis of " + whose + " has no length");
  }

  bool take_limits(const element& e, const std::string& whose, joint& into) {
    const element* const limit = e.FirstChildElement("limit");
    if (!limit) return true;
    const std::string of = "the limit of " + whose;
    joint_limits& read = into.limits;
    if (!from_.take(*limit, "effort", read.effort, of) || !from_.take(*limit, "velocity", read.velocity, of))
      return false;
    if (into.is != joint_kind::revolute && into.is != joint_kind::prismatic) return true;
    read.lower = read.upper = 0; // what URDF takes them for where they are left out
    if (!from_.take(*limit, "lower", read.lower, of) || !from_.take(*limit, "upper", read.upper, of))
      return false;
    if (read.lower > read.upper) from_.note(*limit, whose + " has a lower limit above its upper one");
    return true;
  }

  bool take_dynamics(const element& e, const std::string& whose, joint& into) {
    const element* const dynamics = e.FirstChildElement("dynamics");
    if (!dynamics) return true;
    if (!from_.take(*dynamics, "damping", into.damping, whose) ||
        !from_.take(*dynamics, "friction", into.friction, whose))
      return false;
    if (into.damping < 0) return from_.fail(*dynamics, "the damping of " + whose + " is negative");
    return into.friction >= 0 || from_.fail(*dynamics, "the friction of " + whose + " is negative");
  }

  bool take_mimic(const element& e, joint& into) {
    const std::string whose = "joint " + shown(into.name);
    if (into.is == joint_kind::fixed) { // as programs leave it that fix joints
      from_.note(e, whose + " is fixed, so its mimic is left out");
      return true;
    }
    const auto name = from_.text(e, "joint", "the mimic of " + whose);
    if (!name) return false;
    mimicry read;
    if (!from_.take(e, "multiplier", read.multiplier, "the mimic of " + whose) ||
        !from_.take(e, "offset", read.offset, "the mimic of " + whose))
      return false;
    const auto at = places_.find(*name);
    if (at == places_.end()) return from_.fail(e, whose + " follows " + shown(*name) + ", which is no joint");
    read.leader = at->second;
    if (!has_one_coordinate(into.is))
      return from_.fail(e, whose + " follows another, but has more than one coordinate");
    const joint_kind leader = into_.joints[static_cast<std::size_t>(read.leader)].is;
    if (leader != joint_kind::fixed && !has_one_coordinate(leader))
      return from_.fail(e, whose + " follows " + shown(*name) + ", which has more than one coordinate");
    into.mimic = read;
    return true;
  }

  /// Fixes a joint where it is at q.
  void fix(joint& j, double q) {
    if (j.is == joint_kind::prismatic)
      j.origin = product(j.origin, pose{no_rotation, {q * j.axis[0], q * j.axis[1], q * j.axis[2]}});
    else
      j.origin = product(j.origin, pose{by_axis(j.axis, q, from_.tolerance()), {}});
    j.is = joint_kind::fixed;
    j.mimic.reset();
  }

  /// By the words of ROS, or those of Drake.
  bool take_gear(const element& in, const std::string& whose, joint& into) {
    for (const element* e = in.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string_view is = e->Name();
      const bool gear = is == "mechanicalReduction" || is == "drake:gear_ratio";
      if (!gear && is != "rotorInertia" && is != "drake:rotor_inertia") continue;
      const char* text = e->Attribute("value");
      if (!text) text = e->GetText();
      std::string_view words = text ? text : "";
      const auto value = number_in(next_word(words));
      if (!value || !next_word(words).empty())
        return from_.fail(*e, "the " + shown(is) + " of " + whose + " is not a finite number");
      if (!gear && *value < 0) return from_.fail(*e, "the rotor inertia of " + whose + " is negative");
      (gear ? into.gear_ratio : into.rotor_inertia) = *value;
    }
    return true;
  }

  document& from_;
  const places& links_;
  robot& into_;
  places places_{};
  std::vector<std::pair<std::size_t, const element*>> mimics_{};
  std::vector<int> lines_{};
};

} // namespace kanexpr::robots::urdf
