#pragma once

#include <kanexpr/robots/robot.hpp>

#include <utility>
#include <vector>

/// The parts of a robot that move as one body.
namespace kanexpr::robots {

/// Links connected by fixed joints. The body is named after the first of them, in whose axes all quantities
/// are expressed.
struct moving_body {
  int link = -1;
  int joint = -1;  ///< the joint that moves the body; -1 for the root
  int parent = -1; ///< index of the parent body; -1 for the root
  pose origin{};   ///< pose of the joint in the axes of the parent
  double mass = 0;
  vector3 center{};
  inertia_matrix inertia{};   ///< about the mass center
  double weightless_mass = 0; ///< the part of the mass on which gravity does not act
  vector3 weightless_center{};

  bool has_mass() const { return mass > 0 || inertia.largest() > 0; }
  bool is_weightless() const { return weightless_mass >= mass; }
};

/// The pose of a link in the axes of the moving body to which it belongs.
struct placed_link {
  int body = -1;
  pose pose_in_body{};
};

struct articulation {
  std::vector<moving_body> bodies{}; ///< each follows its parent; the first contains the root
  std::vector<placed_link> links{};  ///< all links, in the order in which the robot lists them
  std::vector<int> joints{};         ///< joints that move independently, in the order of the robot
};

namespace detail {

inline inertia_matrix sum(const inertia_matrix& a, const inertia_matrix& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}

/// The inertia of a point mass at r about the origin.
inline inertia_matrix point_inertia(double mass, const vector3& r) {
  return {mass * (r[1] * r[1] + r[2] * r[2]),
          mass * (r[2] * r[2] + r[0] * r[0]),
          mass * (r[0] * r[0] + r[1] * r[1]),
          -mass * r[0] * r[1],
          -mass * r[1] * r[2],
          -mass * r[2] * r[0]};
}

inline inertia_matrix rotated(const rotation& by, const inertia_matrix& i) {
  if (by == no_rotation) return i; // exactly
  const rotation given{{{i.xx, i.xy, i.zx}, {i.xy, i.yy, i.yz}, {i.zx, i.yz, i.zz}}};
  const rotation t = product(by, product(given, transposed(by)));
  return {t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[2][0]};
}

/// Adds a mass to a total mass and updates the mass center.
inline void add_mass(double& mass, vector3& center, double added, const vector3& at) {
  const double whole = mass + added;
  if (mass > 0 && added > 0)
    for (std::size_t i = 0; i < 3; ++i) center[i] = (mass * center[i] + added * at[i]) / whole;
  else if (added > 0)
    center = at;
  mass = whole;
}

/// Adds the mass of a link. If the body has only one link, its mass center is exactly that of the link.
inline void add(moving_body& to, const inertial& of, const pose& at) {
  const pose center = product(at, of.center);
  const inertia_matrix inertia = rotated(center.orientation, of.inertia);
  if (!to.has_mass()) {
    to.mass = of.mass, to.center = center.position, to.inertia = inertia;
    return;
  }
  double whole = to.mass;
  vector3 middle = to.center;
  add_mass(whole, middle, of.mass, center.position);
  to.inertia = sum(sum(to.inertia, point_inertia(to.mass, to.center - middle)),
                   sum(inertia, point_inertia(of.mass, center.position - middle)));
  to.mass = whole, to.center = middle;
}

} // namespace detail

/// Merges links connected by fixed joints: visits the links depth first, starting at the root.
class body_merger {
public:
  explicit body_merger(const robot& r) : robot_(r), outward_(r.links.size()) {
    into_.links.resize(r.links.size());
  }

  articulation merge() {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const joint& each = robot_.joints[j];
      entry(outward_, each.parent).push_back(static_cast<int>(j));
      if (each.kind != joint_kind::fixed && !each.mimic) into_.joints.push_back(static_cast<int>(j));
    }
    into_.bodies.push_back({.link = robot_.root});
    open_.push_back({robot_.root, 0, {}});
    while (!open_.empty()) {
      const step next = open_.back();
      open_.pop_back();
      visit(next);
    }
    return std::move(into_);
  }

private:
  /// A link to visit, its body, and the moving joint that leads to it, if any.
  struct step {
    int link = -1, body = -1;
    pose at{};
    int joint = -1;
  };

  void visit(step s) {
    if (s.joint >= 0) {
      into_.bodies.push_back({.link = s.link, .joint = s.joint, .parent = s.body, .origin = s.at});
      s.body = static_cast<int>(into_.bodies.size()) - 1;
      s.at = {};
    }
    const auto link = static_cast<std::size_t>(s.link);
    into_.links[link] = {s.body, s.at};
    if (const auto& of = robot_.links[link].inertial) {
      moving_body& b = entry(into_.bodies, s.body);
      detail::add(b, *of, s.at);
      if (robot_.links[link].weightless)
        detail::add_mass(b.weightless_mass, b.weightless_center, of->mass,
                         product(s.at, of->center).position);
    }
    const std::vector<int>& next = outward_[link];
    for (auto j = next.rbegin(); j != next.rend(); ++j) {
      const joint& by = entry(robot_.joints, *j);
      const bool moves = by.kind != joint_kind::fixed;
      open_.push_back({by.child, s.body, product(s.at, by.origin), moves ? *j : -1});
    }
  }

  const robot& robot_;
  articulation into_{};
  std::vector<std::vector<int>>
      outward_; ///< the joints to the children of each link, in the order of the robot
  std::vector<step> open_{};
};

/// Merges links connected by fixed joints, using the parallel-axis theorem.
inline articulation articulation_of(const robot& r) { return body_merger(r).merge(); }

/// Sets gravity to zero if it acts on no link that can move. Links fixed to a link named "world" cannot move.
inline void simplify_gravity(robot& r) {
  const articulation moving = articulation_of(r);
  const bool in_world = entry(r.links, r.root).name == "world";
  bool any = false, all = true;
  for (const moving_body& b : moving.bodies) {
    if (in_world && b.joint < 0) continue;
    any = any || b.weightless_mass > 0;
    all = all && b.is_weightless();
  }
  if (!any || !all) return;
  r.gravity = vector3{};
  for (link& l : r.links) l.weightless = false;
}

/// The relation between a joint and the independent joint that it mimics: q = multiplier · q_leader + offset.
inline mimic_rule resolved_mimic(const robot& r, int joint) {
  mimic_rule resolved{joint, 1, 0};
  while (const auto& next = entry(r.joints, resolved.leader).mimic) {
    resolved.offset += resolved.multiplier * next->offset;
    resolved.multiplier *= next->multiplier;
    resolved.leader = next->leader;
  }
  return resolved;
}

} // namespace kanexpr::robots
