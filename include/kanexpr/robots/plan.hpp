#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/check_inertial.hpp>
#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/identifiers.hpp>
#include <kanexpr/robots/model_options.hpp>
#include <kanexpr/robots/shown.hpp>

#include <string>
#include <utility>
#include <vector>

/// The plan for the model of a robot: its moving bodies and the names of all symbols and links.
namespace kanexpr::robots {

/// A joint that moves independently; a floating base has one, too.
struct planned_joint {
  int joint = -1; ///< index in the robot; -1 for the floating base
  joint_kind is = joint_kind::floating;
  std::string called{};
  std::vector<std::string> coordinates{}, speeds{};
  std::string input{}; ///< empty if there is none
};

struct plan {
  articulation what{};
  std::vector<planned_joint> joints{}; ///< the joint of the base, then the others in the order of the file
  std::vector<std::string> links{};    ///< names of all links
  std::vector<int> joint_of{};         ///< index in `joints` for each joint of the robot; -1 if it has none
  std::vector<std::string> renamed{};  ///< names that differ from those of the file: "Finger_a is finger a"
  std::string mistake{};               ///< the reason why there is no model; empty if there is one

  const planned_joint* joint_by(int of_robot) const {
    const int place = joint_of[static_cast<std::size_t>(of_robot)];
    return place < 0 ? nullptr : &joints[static_cast<std::size_t>(place)];
  }
};

/// A joint with one coordinate, driven by a torque or a force.
inline planned_joint single(const robot& r, int place, const std::string& called) {
  const joint_kind is = r.joints[static_cast<std::size_t>(place)].is;
  return {place,           is,
          called,          {"q_" + called},
          {"u_" + called}, (is == joint_kind::prismatic ? "F_" : "T_") + called};
}

inline planned_joint planar(int place, const std::string& called) {
  return {place,
          joint_kind::planar,
          called,
          {"px_" + called, "py_" + called, "q_" + called},
          {"vx_" + called, "vy_" + called, "u_" + called},
          {}};
}

/// A floating joint: position, unit quaternion with the scalar part last, and velocity and angular velocity
/// in the axes of the child.
inline planned_joint floating(int place, const std::string& called) {
  planned_joint made{place, joint_kind::floating, called, {}, {}, {}};
  const std::string behind = called.empty() ? "" : "_" + called;
  for (const char* q : {"px", "py", "pz", "e1", "e2", "e3", "e0"}) made.coordinates.push_back(q + behind);
  for (const char* u : {"vx", "vy", "vz", "wx", "wy", "wz"}) made.speeds.push_back(u + behind);
  return made;
}

/// Reports a number that overflows when links are merged; empty if none does.
inline std::string overflowing_in(const robot& r, const articulation& a) {
  const auto too_large = [&](int link) {
    return "the numbers of link " + shown(r.links[static_cast<std::size_t>(link)].name) +
           " are so large that they overflow";
  };
  const auto is_finite = [](const vector3& v) { return numeric::is_finite(v[0] + v[1] + v[2]); };
  for (const moving_body& b : a.bodies) {
    const inertia_matrix& i = b.inertia;
    if (!numeric::is_finite(b.mass + i.xx + i.yy + i.zz + i.xy + i.yz + i.zx) || !is_finite(b.center) ||
        !is_finite(b.origin.at))
      return too_large(b.link);
  }
  for (std::size_t l = 0; l < a.links.size(); ++l)
    if (!is_finite(a.links[l].at.at)) return too_large(static_cast<int>(l));
  for (const moving_body& b : a.bodies) {
    if (b.joint < 0) continue;
    const joint& j = r.joints[static_cast<std::size_t>(b.joint)];
    const mimicry how = followed_by(r, b.joint);
    if (!numeric::is_finite(j.gear_ratio * j.gear_ratio * j.rotor_inertia + how.multiplier + how.offset))
      return "the gear of joint " + shown(j.name) + " is so large that it overflows";
  }
  return {};
}

/// Reports an inertia that is negative about some axis; empty if there is none.
inline std::string indefinite_in(const robot& r, const articulation& a, const model_options& options) {
  for (const moving_body& b : a.bodies)
    if ((b.joint >= 0 || options.base == base_kind::floating) && is_indefinite(b.inertia))
      return "the inertia of link " + shown(r.links[static_cast<std::size_t>(b.link)].name) +
             ", with the links fixed to it, is indefinite: its moment about some axis is negative";
  return {};
}

/// Notes a name that differs from the name in the file, unless only the first letter was capitalized.
inline void note_name(plan& p, const std::string& called, const std::string& in_file) {
  std::string small_first = called;
  if (!in_file.empty()) small_first[0] = in_file[0];
  const bool is_capital = called[0] >= 'A' && called[0] <= 'Z';
  const bool first_differs =
      !in_file.empty() && called[0] != in_file[0] && !(is_capital && called[0] - 'A' + 'a' == in_file[0]);
  if (first_differs || small_first != in_file) p.renamed.push_back(called + " is " + shown(in_file));
}

inline plan plan_of(const robot& r, const model_options& options) {
  constexpr std::size_t most_bodies = 400;
  plan p;
  if (p.mistake = check_robot(r); !p.mistake.empty()) return p;
  if (!numeric::is_finite(options.gravity.value_or(0))) {
    p.mistake = "the gravity in the model options is not finite";
    return p;
  }
  p.what = articulation_of(r);
  if (p.what.bodies.size() > most_bodies) {
    p.mistake = "the robot has " + std::to_string(p.what.bodies.size()) +
                " moving links; a model has at most " + std::to_string(most_bodies);
    return p;
  }
  if (p.mistake = overflowing_in(r, p.what); !p.mistake.empty()) return p;
  if (p.mistake = indefinite_in(r, p.what, options); !p.mistake.empty()) return p;
  identifiers names;
  for (const char* taken : {"N", "O", "System"}) names.reserve(taken);
  for (const link& l : r.links) {
    p.links.push_back(names.type(l.name, {"", "_home", "_origin", "_start", "_base", "_center", "_body",
                                          "_rotor", "_shape", "_weightless"}));
    note_name(p, p.links.back(), l.name);
  }
  if (options.base == base_kind::floating) p.joints.push_back(floating(-1, ""));
  p.joint_of.assign(r.joints.size(), -1);
  for (int j : p.what.joints) {
    const joint& each = r.joints[static_cast<std::size_t>(j)];
    const std::string called = names.joint(each.name, {"q_", "u_", "T_", "F_"});
    note_name(p, called, each.name);
    p.joint_of[static_cast<std::size_t>(j)] = static_cast<int>(p.joints.size());
    p.joints.push_back(each.is == joint_kind::floating ? floating(j, called)
                       : each.is == joint_kind::planar ? planar(j, called)
                                                       : single(r, j, called));
  }
  if (p.joints.empty()) p.mistake = "no joint of the robot moves, and its base is fixed";
  return p;
}

/// Returns two directions normal to an axis that form a right-handed triad with it; for the axis z, they are
/// x and y.
inline std::pair<vector3, vector3> across(const vector3& axis) {
  std::size_t most = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(axis[i]) > std::abs(axis[most])) most = i;
  const std::size_t next = (most + 1) % 3;
  vector3 first{};
  first[next] = 1;
  for (std::size_t i = 0; i < 3; ++i) first[i] -= axis[next] * axis[i];
  first = direction_of(first, 0);
  return {first, cross(axis, first)};
}

} // namespace kanexpr::robots
