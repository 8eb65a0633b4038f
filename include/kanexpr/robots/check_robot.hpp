#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/shown.hpp>

#include <cmath>
#include <string>
#include <vector>

/// Checks a robot, which may come from a file or from a program.
namespace kanexpr::robots {

/// A sentence that describes a mistake, empty if there is none, and the joint that it concerns.
struct robot_mistake {
  std::string what{};
  int joint = -1; ///< -1 for the whole robot
};

/// The link that is not the child of any joint, or a mistake if the joints do not form a tree.
struct found_root {
  int link = -1;
  robot_mistake mistake{};
};

namespace detail {

inline std::string called(const robot& r, int link) {
  return shown(r.links[static_cast<std::size_t>(link)].name);
}

/// Checks that the path from every link to its parent, and so on, leads to the root.
inline robot_mistake unreached_in(const robot& r, const std::vector<int>& leads_to, int root) {
  std::vector<bool> reached(leads_to.size(), false);
  reached[static_cast<std::size_t>(root)] = true;
  std::vector<std::size_t> way;
  for (std::size_t l = 0; l < leads_to.size(); ++l) {
    way.clear();
    for (std::size_t at = l; !reached[at];
         at = static_cast<std::size_t>(r.joints[static_cast<std::size_t>(leads_to[at])].parent)) {
      if (way.size() > leads_to.size())
        return {"the joints form a loop: link " + called(r, static_cast<int>(l)) + " is its own ancestor",
                leads_to[l]};
      way.push_back(at);
    }
    for (std::size_t each : way) reached[each] = true;
  }
  return {};
}

inline bool is_rotation(const rotation& t) {
  constexpr double tolerance = 1e-6; // the accuracy of files with few digits
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(dot(t[i], t[i]) - 1) < tolerance)) return false;
    if (!(std::abs(dot(t[i], t[(i + 1) % 3])) < tolerance)) return false;
  }
  return dot(t[0], cross(t[1], t[2])) > 0;
}
inline bool is_finite(const vector3& v) { return numeric::is_finite(v[0] + v[1] + v[2]); }
inline bool is_placed(const pose& p) { return is_rotation(p.turn) && is_finite(p.at); }

inline std::string wrong_with(const link& l) {
  if (!l.inertial) return {};
  const std::string whose = "link " + shown(l.name);
  const inertial& i = *l.inertial;
  const inertia_matrix& m = i.inertia;
  if (!numeric::is_finite(i.mass + m.xx + m.yy + m.zz + m.xy + m.yz + m.zx))
    return "the mass or the inertia of " + whose + " is not a finite number";
  if (!is_placed(i.center))
    return "the mass center of " + whose + " is not placed by finite numbers and a rotation matrix";
  return i.mass < 0 ? "the mass of " + whose + " is negative" : "";
}

inline std::string wrong_with_mimic(const robot& r, const joint& j) {
  const std::string whose = "joint " + shown(j.name);
  const joint* at = &j;
  for (std::size_t steps = 0; at->mimic; ++steps) {
    const mimicry& m = *at->mimic;
    if (m.leader < 0 || static_cast<std::size_t>(m.leader) >= r.joints.size())
      return whose + " mimics a joint that does not exist";
    if (!numeric::is_finite(m.multiplier) || !numeric::is_finite(m.offset))
      return whose + " mimics another joint with a multiplier or offset that is not finite";
    if (steps == r.joints.size()) return whose + " mimics a joint that in turn mimics it";
    if (!has_one_coordinate(at->is))
      return whose + " mimics another joint but does not have exactly one coordinate";
    at = &r.joints[static_cast<std::size_t>(m.leader)];
    if (!has_one_coordinate(at->is))
      return whose + " mimics " + shown(at->name) + ", which does not have exactly one coordinate";
  }
  return {};
}

inline std::string wrong_with(const robot& r, const joint& j) {
  const std::string whose = "joint " + shown(j.name);
  const auto is_link = [&](int l) { return l >= 0 && static_cast<std::size_t>(l) < r.links.size(); };
  if (!is_link(j.parent) || !is_link(j.child))
    return whose + " has a parent or a child that is not among the links";
  if (j.parent == j.child) return whose + " connects a link to itself";
  if (!is_placed(j.origin))
    return "the origin of " + whose + " is not placed by finite numbers and a rotation matrix";
  if (has_axis(j.is) && !(std::abs(dot(j.axis, j.axis) - 1) < 1e-6))
    return "the axis of " + whose + " does not have length 1";
  if (!(j.damping >= 0) || !(j.friction >= 0) || !(j.rotor_inertia >= 0) ||
      !numeric::is_finite(j.damping + j.friction + j.rotor_inertia + j.gear_ratio))
    return "the damping, friction or rotor of " + whose + " is negative or not finite";
  if (!(std::abs(j.gear_ratio) > 0)) return "the gear ratio of " + whose + " is 0";
  return wrong_with_mimic(r, j);
}

} // namespace detail

/// Finds the root of a robot whose joints all have a parent and a child among the links.
inline found_root root_of(const robot& r) {
  std::vector<int> leads_to(r.links.size(), -1);
  for (std::size_t j = 0; j < r.joints.size(); ++j) {
    int& known = leads_to[static_cast<std::size_t>(r.joints[j].child)];
    if (known >= 0)
      return {-1,
              {"link " + detail::called(r, r.joints[j].child) + " is the child of two joints, " +
                   shown(r.joints[static_cast<std::size_t>(known)].name) + " and " + shown(r.joints[j].name),
               static_cast<int>(j)}};
    known = static_cast<int>(j);
  }
  int root = -1;
  for (std::size_t l = 0; l < leads_to.size(); ++l) {
    if (leads_to[l] >= 0) continue;
    if (root >= 0)
      return {-1,
              {"no joint has link " + detail::called(r, root) + " or link " +
               detail::called(r, static_cast<int>(l)) + "as its child; a robot has one such link, its root"}};
    root = static_cast<int>(l);
  }
  if (root < 0) return {-1, {"the joints form a loop: every link is the child of a joint"}};
  return {root, detail::unreached_in(r, leads_to, root)};
}

/// Returns the first mistake in a robot, as a sentence; empty if there is none.
inline std::string check_robot(const robot& r) {
  if (r.links.empty()) return "the robot has no links";
  if (r.gravity && !detail::is_finite(*r.gravity)) return "the gravity of the robot is not finite";
  for (const link& l : r.links)
    if (std::string wrong = detail::wrong_with(l); !wrong.empty()) return wrong;
  for (const joint& j : r.joints)
    if (std::string wrong = detail::wrong_with(r, j); !wrong.empty()) return wrong;
  const found_root found = root_of(r);
  if (!found.mistake.what.empty() || found.link == r.root) return found.mistake.what;
  return "the root of the robot must be link " + detail::called(r, found.link) +
         ", which is the child of no joint";
}

} // namespace kanexpr::robots
