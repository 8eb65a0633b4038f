#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/identifiers.hpp>
#include <kanexpr/robots/options.hpp>
#include <kanexpr/robots/physical_quantity.hpp>
#include <kanexpr/robots/pose.hpp>
#include <kanexpr/robots/robot.hpp>

#include <initializer_list>
#include <string>
#include <vector>

/// The plan for the model of a robot: its moving bodies and the names of all symbols and links.
namespace kanexpr::robots {

/// The name of a symbol and the quantity that it denotes.
struct planned_symbol {
  std::string called{};
  physical_quantity is{};
};

/// A joint that moves independently; a floating base has one, too.
struct planned_joint {
  int joint = -1; ///< index in the robot; -1 for the floating base
  joint_kind kind = joint_kind::floating;
  std::string called{};
  std::vector<planned_symbol> coordinates{}, speeds{};
  planned_symbol input{}; ///< its name is empty if there is none
};

struct plan {
  const robot& source; ///< must outlive the plan
  model_options options;
  articulation tree{};
  std::vector<planned_joint> joints{}; ///< the joint of the base, then the others in the order of the file
  std::vector<std::string> links{};    ///< names of all links
  std::vector<int> joint_of{};         ///< index in `joints` for each joint of the robot; -1 if it has none
  std::vector<std::string> renamed{};  ///< names that differ from those in the file: "Finger_a is finger a"
  std::string mistake{};               ///< the reason why there is no model; empty if there is one

  const std::string& name(int link) const { return entry(links, link); }
  const planned_joint* joint_by(int of_robot) const {
    const int place = entry(joint_of, of_robot);
    return place < 0 ? nullptr : &entry(joints, place);
  }
  const joint& joint_of_body(const moving_body& b) const { return entry(source.joints, b.joint); }
  const moving_body& parent_of(const moving_body& b) const { return entry(tree.bodies, b.parent); }

  /// The quantity by which the motion of the leader of a mimic joint is multiplied.
  physical_quantity multiplier_of(int joint) const {
    const auto slides = [&](int j) { return entry(source.joints, j).kind == joint_kind::prismatic; };
    const bool leader_slides = slides(resolved_mimic(source, joint).leader);
    if (slides(joint) == leader_slides) return physical_quantity::ratio;
    return leader_slides ? physical_quantity::angle_per_length : physical_quantity::length_per_angle;
  }

  bool has_floating_base() const { return options.base == base_kind::floating; }
  bool is_on_ground(const moving_body& b) const { return b.joint < 0 && !has_floating_base(); }
  /// Whether the values in the file are written as numbers instead of parameters.
  bool binds_numbers() const { return options.bind == binding::numbers; }
  bool has_friction(const joint& j) const {
    return options.friction && j.friction > 0 && has_one_coordinate(j.kind);
  }
  /// Whether the limits of a joint are stops.
  bool has_stops(const joint& j) const {
    const bool is_limited = numeric::is_finite(j.limits.lower) || numeric::is_finite(j.limits.upper);
    return options.stops && is_limited && has_one_coordinate(j.kind) && !j.mimic &&
           j.limits.lower < j.limits.upper;
  }
};

/// Names the symbols of a joint after it; those of the base, which has no name, have no suffix. A floating
/// joint has a position, a unit quaternion with the scalar part last, and the velocity and angular velocity
/// in the axes of the child.
inline planned_joint plan_joint(int index, joint_kind kind, const std::string& called) {
  planned_joint made{index, kind, called, {}, {}, {}};
  const auto add = [&](std::vector<planned_symbol>& to, std::initializer_list<const char*> prefixes,
                       physical_quantity is) {
    for (const char* prefix : prefixes) to.push_back({prefix + (called.empty() ? "" : "_" + called), is});
  };
  const bool slides = kind == joint_kind::prismatic;
  if (kind == joint_kind::floating) {
    add(made.coordinates, {"px", "py", "pz"}, physical_quantity::length);
    add(made.coordinates, {"e1", "e2", "e3", "e0"}, physical_quantity::ratio);
    add(made.speeds, {"vx", "vy", "vz"}, physical_quantity::velocity);
    add(made.speeds, {"wx", "wy", "wz"}, physical_quantity::angular_velocity);
  } else if (kind == joint_kind::planar) {
    add(made.coordinates, {"px", "py"}, physical_quantity::length);
    add(made.coordinates, {"q"}, physical_quantity::angle);
    add(made.speeds, {"vx", "vy"}, physical_quantity::velocity);
    add(made.speeds, {"u"}, physical_quantity::angular_velocity);
  } else {
    add(made.coordinates, {"q"}, slides ? physical_quantity::length : physical_quantity::angle);
    add(made.speeds, {"u"}, slides ? physical_quantity::velocity : physical_quantity::angular_velocity);
    made.input = {(slides ? "F_" : "T_") + called,
                  slides ? physical_quantity::force : physical_quantity::torque};
  }
  return made;
}

/// Reports a number that overflows when links are merged; empty if none does.
inline std::string check_overflow(const robot& r, const articulation& a) {
  const auto too_large = [&](int link) {
    return "the values of link " + printable(entry(r.links, link).name) + " are so large that they overflow";
  };
  for (const moving_body& b : a.bodies)
    if (!numeric::is_finite(b.mass + b.inertia.sum()) || !is_finite(b.center) ||
        !is_finite(b.origin.position))
      return too_large(b.link);
  for (std::size_t l = 0; l < a.links.size(); ++l)
    if (!is_finite(a.links[l].pose_in_body.position)) return too_large(static_cast<int>(l));
  for (const moving_body& b : a.bodies) {
    if (b.joint < 0) continue;
    const joint& j = entry(r.joints, b.joint);
    const mimic_rule rule = resolved_mimic(r, b.joint);
    if (!numeric::is_finite(j.reflected_inertia() + rule.multiplier + rule.offset))
      return "the rotor or the mimic rule of joint " + printable(j.name) +
             " has values so large that they overflow";
  }
  return {};
}

/// Reports an inertia that is negative about some axis; empty if there is none.
inline std::string check_inertias(const plan& p) {
  for (const moving_body& b : p.tree.bodies)
    if (!p.is_on_ground(b) && is_indefinite(b.inertia))
      return "the inertia of link " + printable(entry(p.source.links, b.link).name) +
             ", with the links fixed to it, is indefinite: its moment about some axis is negative";
  return {};
}

/// Returns the first reason why the robot has no model; empty if there is none. Sets the moving bodies.
inline std::string plan_bodies(plan& p) {
  constexpr std::size_t max_bodies = 400;
  if (std::string wrong = check_robot(p.source); !wrong.empty()) return wrong;
  if (!numeric::is_finite(p.options.gravity.value_or(0)))
    return "the gravity in the model options is not finite";
  p.tree = articulation_of(p.source);
  if (p.tree.bodies.size() > max_bodies)
    return "the robot has " + std::to_string(p.tree.bodies.size()) + " moving links; a model has at most " +
           std::to_string(max_bodies);
  if (std::string wrong = check_overflow(p.source, p.tree); !wrong.empty()) return wrong;
  return check_inertias(p);
}

/// Notes a name that differs from the name in the file, unless only the first letter was capitalized.
inline void note_name(plan& p, const std::string& called, const std::string& in_file) {
  std::string small_first = called;
  if (!in_file.empty()) small_first[0] = in_file[0];
  const bool is_capital = called[0] >= 'A' && called[0] <= 'Z';
  const bool first_differs =
      !in_file.empty() && called[0] != in_file[0] && !(is_capital && called[0] - 'A' + 'a' == in_file[0]);
  if (first_differs || small_first != in_file) p.renamed.push_back(called + " is " + printable(in_file));
}

inline plan plan_of(const robot& r, const model_options& options) {
  plan p{r, options};
  if (p.mistake = plan_bodies(p); !p.mistake.empty()) return p;
  identifiers names;
  for (const char* taken : {"N", "O", "System"}) names.reserve(taken);
  for (const link& l : r.links) {
    p.links.push_back(names.type(l.name, {"", "_home", "_origin", "_start", "_base", "_center", "_body",
                                          "_rotor", "_shape", "_weightless"}));
    note_name(p, p.links.back(), l.name);
  }
  if (p.has_floating_base()) p.joints.push_back(plan_joint(-1, joint_kind::floating, ""));
  p.joint_of.assign(r.joints.size(), -1);
  for (int j : p.tree.joints) {
    const joint& each = entry(r.joints, j);
    const std::string called = names.joint(each.name, {"q_", "u_", "T_", "F_"});
    note_name(p, called, each.name);
    entry(p.joint_of, j) = static_cast<int>(p.joints.size());
    p.joints.push_back(plan_joint(j, each.kind, called));
  }
  if (p.joints.empty()) p.mistake = "no joint of the robot moves, and its base is fixed";
  return p;
}

} // namespace kanexpr::robots
