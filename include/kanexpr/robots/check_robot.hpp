#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/robot.hpp>

#include <cmath>
#include <string>
#include <vector>

/// Checks the inertias of links, and complete robots, whether they come from a file or from a program.
namespace kanexpr::robots {

namespace detail {

/// Whether factor·inertia + shift·E is positive semidefinite, judged by its principal minors.
inline bool is_semidefinite(const inertia_matrix& i, double factor, double shift) {
  const double xx = factor * i.xx + shift, yy = factor * i.yy + shift, zz = factor * i.zz + shift;
  const double xy = factor * i.xy, yz = factor * i.yz, zx = factor * i.zx;
  const double whole = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && yy * zz >= yz * yz && zz * xx >= zx * zx &&
         whole >= 0;
}

/// The inertia scaled so that its largest entry is 1.
inline inertia_matrix scaled(inertia_matrix i) {
  const double largest = i.largest();
  if (!(largest > 0)) return {};
  for (double* e : {&i.xx, &i.yy, &i.zz, &i.xy, &i.yz, &i.zx}) *e /= largest;
  return i;
}

} // namespace detail

/// Whether the moment of inertia about some axis is negative by more than rounding.
inline bool is_indefinite(const inertia_matrix& i) {
  return !detail::is_semidefinite(detail::scaled(i), 1, 1e-9);
}

/// Whether the inertia is negligible compared with the mass (a radius of gyration below one micrometer):
/// files contain 1e-20 where a program computed zero.
inline bool is_negligible(const inertia_matrix& i, double mass) { return i.largest() <= 1e-12 * mass; }

/// Whether no mass distribution can have this inertia because one principal moment exceeds the sum of the
/// other two by more than the rounding of published numbers.
inline bool is_unphysical(const inertia_matrix& i) {
  const inertia_matrix s = detail::scaled(i);
  const double trace = s.xx + s.yy + s.zz;
  return !detail::is_semidefinite(s, -1, (0.5 + 1e-3) * trace);
}

/// A mistake in the inertial properties of a link, and a note about unusual values; both may be empty.
struct inertial_findings {
  std::string mistake{}, note{};
};

/// Checks the inertial properties of a link; sets an inertia that consists of rounding errors to zero.
inline inertial_findings check_inertial(inertial& of, const std::string& whose) {
  inertia_matrix& i = of.inertia;
  if (of.mass < 0) return {"the mass of " + whose + " is negative", {}};
  if (is_indefinite(i) && is_negligible(i, of.mass)) i = {};
  if (i.xx < 0 || i.yy < 0 || i.zz < 0) return {"a moment of inertia of " + whose + " is negative", {}};
  const std::string inertia = "the inertia of " + whose;
  if (!(of.mass > 0) && i.largest() > 0)
    return {{}, inertia + " is given without a mass and is used as written"};
  if (is_indefinite(i)) // links fixed to this one may compensate for it
    return {{}, inertia + " is indefinite: its moment about some axis is negative"};
  if (is_unphysical(i))
    return {{}, inertia + " is not physical: one principal moment exceeds the sum of the other two"};
  return {};
}

/// The link that is not the child of any joint, or a mistake if the joints do not form a tree.
struct found_root {
  int link = -1;
  std::string mistake{}; ///< a sentence; empty if there is none
  int joint = -1;        ///< the joint that the mistake concerns; -1 for the whole robot
};

namespace detail {

inline std::string link_name(const robot& r, int link) { return printable(entry(r.links, link).name); }

/// Checks that the path from every link through its ancestors leads to the root.
inline found_root check_connected(const robot& r, const std::vector<int>& leads_to, int root) {
  std::vector<bool> reached(leads_to.size(), false);
  reached[static_cast<std::size_t>(root)] = true;
  std::vector<std::size_t> way;
  for (std::size_t l = 0; l < leads_to.size(); ++l) {
    way.clear();
    for (std::size_t at = l; !reached[at];
         at = static_cast<std::size_t>(entry(r.joints, leads_to[at]).parent)) {
      if (way.size() > leads_to.size())
        return {-1,
                "the joints form a loop: link " + link_name(r, static_cast<int>(l)) + " is its own ancestor",
                leads_to[l]};
      way.push_back(at);
    }
    for (std::size_t each : way) reached[each] = true;
  }
  return {root};
}

inline bool is_rotation(const rotation& t) {
  constexpr double tolerance = 1e-6; // the accuracy of files with few digits
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(dot(t[i], t[i]) - 1) < tolerance)) return false;
    if (!(std::abs(dot(t[i], t[(i + 1) % 3])) < tolerance)) return false;
  }
  return dot(t[0], cross(t[1], t[2])) > 0;
}
inline bool is_valid(const pose& p) { return is_rotation(p.orientation) && is_finite(p.position); }

inline std::string mistake_in(const link& l) {
  if (!l.inertial) return {};
  const std::string whose = "link " + printable(l.name);
  const inertial& i = *l.inertial;
  if (!numeric::is_finite(i.mass + i.inertia.sum()))
    return "the mass or the inertia of " + whose + " is not a finite number";
  if (!is_valid(i.center))
    return "the pose of the mass center of " + whose +
           " must consist of finite numbers and a rotation matrix";
  return i.mass < 0 ? "the mass of " + whose + " is negative" : "";
}

inline std::string mistake_in_mimic(const robot& r, const joint& j) {
  const std::string whose = "joint " + printable(j.name);
  const joint* at = &j;
  for (std::size_t steps = 0; at->mimic; ++steps) {
    const mimic_rule& m = *at->mimic;
    if (m.leader < 0 || static_cast<std::size_t>(m.leader) >= r.joints.size())
      return whose + " mimics a joint that does not exist";
    if (!numeric::is_finite(m.multiplier) || !numeric::is_finite(m.offset))
      return whose + " mimics another joint with a multiplier or offset that is not finite";
    if (steps == r.joints.size()) return whose + " mimics a joint that in turn mimics it";
    if (!has_one_coordinate(at->kind))
      return whose + " mimics another joint but does not have exactly one coordinate";
    at = &entry(r.joints, m.leader);
    if (!has_one_coordinate(at->kind))
      return whose + " mimics " + printable(at->name) + ", which does not have exactly one coordinate";
  }
  return {};
}

inline std::string mistake_in(const robot& r, const joint& j) {
  const std::string whose = "joint " + printable(j.name);
  const auto is_link = [&](int l) { return l >= 0 && static_cast<std::size_t>(l) < r.links.size(); };
  if (!is_link(j.parent) || !is_link(j.child))
    return whose + " has a parent or a child that is not among the links";
  if (j.parent == j.child) return whose + " connects a link to itself";
  if (!is_valid(j.origin))
    return "the origin of " + whose + " must consist of finite numbers and a rotation matrix";
  if (has_axis(j.kind) && !(std::abs(dot(j.axis, j.axis) - 1) < 1e-6))
    return "the axis of " + whose + " does not have length 1";
  if (!(j.damping >= 0) || !(j.friction >= 0) || !(j.rotor_inertia >= 0) ||
      !numeric::is_finite(j.damping + j.friction + j.rotor_inertia + j.gear_ratio))
    return "the damping, friction or rotor of " + whose + " is negative or not finite";
  if (!(std::abs(j.gear_ratio) > 0)) return "the gear ratio of " + whose + " is 0";
  return mistake_in_mimic(r, j);
}

} // namespace detail

/// Finds the root of a robot whose joints all have a parent and a child among the links.
inline found_root root_of(const robot& r) {
  std::vector<int> leads_to(r.links.size(), -1);
  for (std::size_t j = 0; j < r.joints.size(); ++j) {
    int& known = entry(leads_to, r.joints[j].child);
    if (known >= 0)
      return {-1,
              "link " + detail::link_name(r, r.joints[j].child) + " is the child of two joints, " +
                  printable(entry(r.joints, known).name) + " and " + printable(r.joints[j].name),
              static_cast<int>(j)};
    known = static_cast<int>(j);
  }
  int root = -1;
  for (std::size_t l = 0; l < leads_to.size(); ++l) {
    if (leads_to[l] >= 0) continue;
    if (root >= 0)
      return {-1, "neither link " + detail::link_name(r, root) + " nor link " +
                      detail::link_name(r, static_cast<int>(l)) +
                      " is the child of a joint; a robot has only one such link, its root"};
    root = static_cast<int>(l);
  }
  if (root < 0) return {-1, "the joints form a loop: every link is the child of a joint"};
  return detail::check_connected(r, leads_to, root);
}

/// Returns the first mistake in a robot, as a sentence; empty if there is none.
inline std::string check_robot(const robot& r) {
  if (r.links.empty()) return "the robot has no links";
  if (r.gravity && !is_finite(*r.gravity)) return "the gravity of the robot is not finite";
  for (const link& l : r.links)
    if (std::string wrong = detail::mistake_in(l); !wrong.empty()) return wrong;
  for (const joint& j : r.joints)
    if (std::string wrong = detail::mistake_in(r, j); !wrong.empty()) return wrong;
  const found_root found = root_of(r);
  if (!found.mistake.empty() || found.link == r.root) return found.mistake;
  return "the root of the robot must be link " + detail::link_name(r, found.link) +
         ", which is not the child of any joint";
}

} // namespace kanexpr::robots
