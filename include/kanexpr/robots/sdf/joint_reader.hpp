#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/sdf/link_reader.hpp>

#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::robots::sdf {

using ignition::math::Pose3d;

/// The poses of the links in the world when all coordinates are zero.
struct placed_links {
  std::map<std::string, int> index_by_name{};
  std::vector<Pose3d> poses{};
};

/// Converts the joints of a model to those of a robot, whose axes pass through the origin of the child. For a
/// joint elsewhere, it adds a massless link at the position of the joint; for a joint with two axes, a
/// massless link between the axes.
class joint_reader {
public:
  joint_reader(urdf::document& from, placed_links& links, robot& into)
      : from_(from), links_(links), into_(into) {}

  /// `scope` is the prefix of the names in the model that contains the joint.
  bool read(const ::sdf::Joint& j, const std::string& scope) {
    const std::string called = scope + j.Name(), whose = "joint " + printable(called);
    std::string child, parent;
    if (!j.ResolveChildLink(child).empty() || !j.ResolveParentLink(parent).empty())
      return from_.fail(line_of(j), whose + " has a parent or a child that is not a link");
    Pose3d joint_pose;
    if (!j.SemanticPose().Resolve(joint_pose, child).empty())
      return from_.fail(line_of(j), "the pose of " + whose + " cannot be resolved");
    const int from = index_of(parent, scope), to = index_of(child, scope);
    if (from < 0 || to < 0)
      return from_.fail(line_of(j), whose + " has a parent or a child that is not a link");
    begin_ = {called, from, to, entry(links_.poses, to), joint_pose.Pos()};
    const bool has_two = j.Type() == ::sdf::JointType::UNIVERSAL || j.Type() == ::sdf::JointType::REVOLUTE2;
    if (j.Axis(1) && !has_two) from_.note(line_of(j), "the second axis of " + whose + " is ignored");
    switch (j.Type()) {
    case ::sdf::JointType::FIXED: return add(joint_kind::fixed, called, to, begin_.child);
    case ::sdf::JointType::REVOLUTE:
    case ::sdf::JointType::CONTINUOUS: return add_turn(j, 0, scope, called, to);
    case ::sdf::JointType::PRISMATIC: return add_slide(j, scope);
    case ::sdf::JointType::UNIVERSAL:
    case ::sdf::JointType::REVOLUTE2: {
      const int cross = add_link(called + "_cross", at_joint());
      return add_turn(j, 0, scope, called, cross) && add_turn(j, 1, scope, called + "_2", to);
    }
    default: break;
    }
    return from_.fail(
        line_of(j),
        whose + " is " + kind_of(j.Type()) +
            ", which is not supported; use fixed, revolute, continuous, prismatic or universal joints");
  }

  bool read_mimics() {
    for (const auto& [place, m] : mimics_) {
      joint& of = into_.joints[place];
      const auto leader = joints_.find(m.leader);
      if (leader == joints_.end())
        return from_.fail(m.line, "joint " + printable(of.name) + " mimics " + printable(m.leader) +
                                      ", which is not a joint");
      of.mimic = {static_cast<int>(leader->second), m.multiplier, m.offset};
    }
    return true;
  }

private:
  struct beginning {
    std::string called{};
    int from = -1, to = -1;
    Pose3d child{};                            ///< in the world
    ignition::math::Vector3d joint_position{}; ///< in the axes of the child
  };
  struct following {
    std::string leader{};
    double multiplier = 1, offset = 0;
    int line = 1;
  };

  static std::string kind_of(::sdf::JointType type) {
    if (type == ::sdf::JointType::BALL) return "a ball joint";
    if (type == ::sdf::JointType::SCREW) return "a screw joint";
    return type == ::sdf::JointType::GEARBOX ? "a gearbox joint" : "a joint of unknown type";
  }

  /// Returns the index of a link. If a joint refers to the ground, the ground becomes the link "world".
  int index_of(const std::string& link, const std::string& scope) {
    if (link == "world") {
      const auto known = links_.index_by_name.find("world");
      return known == links_.index_by_name.end() ? add_link("world", Pose3d::Zero) : known->second;
    }
    const auto found = links_.index_by_name.find(scope + link);
    return found == links_.index_by_name.end() ? -1 : found->second;
  }
  int add_link(const std::string& called, const Pose3d& at) {
    link made;
    made.name = called;
    into_.links.push_back(std::move(made));
    links_.poses.push_back(at);
    const int place = static_cast<int>(into_.links.size()) - 1;
    links_.index_by_name.emplace(called, place);
    return place;
  }
  Pose3d at_joint() const {
    return begin_.child * Pose3d(begin_.joint_position, ignition::math::Quaterniond::Identity);
  }

  /// Adds a joint from the most recently added link to a link with the pose `at`.
  bool add(joint_kind is, const std::string& called, int to, const Pose3d& at) {
    const Pose3d seen = entry(links_.poses, begin_.from).Inverse() * at;
    joint made;
    made.name = called, made.kind = is, made.parent = begin_.from, made.child = to;
    made.origin = pose_of(seen, from_.tolerance());
    joints_.emplace(called, into_.joints.size());
    into_.joints.push_back(std::move(made));
    begin_.from = to;
    return true;
  }

  bool add_slide(const ::sdf::Joint& j, const std::string& scope) {
    return add(joint_kind::prismatic, begin_.called, begin_.to, begin_.child) && read_axis(j, 0, scope);
  }
  /// Adds a revolute joint, and a link on its axis if the axis does not pass through the origin of the child.
  bool add_turn(const ::sdf::Joint& j, unsigned which, const std::string& scope, const std::string& called,
                int to) {
    const bool to_cross = to != begin_.to;
    vector3 axis{};
    if (!axis_of(j, which, axis)) return false;
    const vector3 beside = cross(vector_of(begin_.joint_position), axis);
    if (to_cross || !(std::sqrt(dot(beside, beside)) > 1e-12)) {
      return add(joint_kind::revolute, called, to, to_cross ? at_joint() : begin_.child) &&
             read_axis(j, which, scope);
    }
    const int on_axis = add_link(called + "_axis", at_joint());
    return add(joint_kind::revolute, called, on_axis, at_joint()) && read_axis(j, which, scope) &&
           add(joint_kind::fixed, called + "_fixed", to, begin_.child);
  }

  bool axis_of(const ::sdf::Joint& j, unsigned which, vector3& into) {
    const ::sdf::JointAxis* axis = j.Axis(which);
    ignition::math::Vector3d along;
    std::string child;
    if (!axis || !j.ResolveChildLink(child).empty() || !axis->ResolveXyz(along, child).empty())
      return from_.fail(line_of(j), "joint " + printable(j.Name()) + " has no axis");
    into = direction_of(vector_of(along), (std::max)(from_.tolerance(), 1e-15));
    return !is_zero(into) ||
           from_.fail(line_of(j), "the axis of joint " + printable(j.Name()) + " has zero length");
  }

  bool read_axis(const ::sdf::Joint& j, unsigned which, const std::string& scope) {
    joint& into = into_.joints.back();
    const std::string whose = "joint " + printable(into.name);
    if (!axis_of(j, which, into.axis)) return false;
    const ::sdf::JointAxis& axis = *j.Axis(which);
    const double none = std::numeric_limits<double>::infinity();
    const auto within = [&](double x) { return std::abs(x) < 1e16 ? x : x < 0 ? -none : none; };
    into.limits = {within(axis.Lower()), within(axis.Upper()),
                   axis.Effort() < 0 ? none : within(axis.Effort()),
                   axis.MaxVelocity() < 0 ? none : within(axis.MaxVelocity())};
    if (into.kind == joint_kind::revolute && !numeric::is_finite(into.limits.lower) &&
        !numeric::is_finite(into.limits.upper))
      into.kind = joint_kind::continuous;
    into.damping = axis.Damping(), into.friction = axis.Friction();
    if (into.damping < 0) return from_.fail(line_of(j), "the damping of " + whose + " is negative");
    if (into.friction < 0) return from_.fail(line_of(j), "the friction of " + whose + " is negative");
    if (std::abs(axis.SpringStiffness()) > 0)
      from_.note(line_of(j), "the spring of " + whose + " is ignored");
    return read_mimic(axis, scope);
  }

  /// Reads the mimic element of a joint. Such elements were introduced in SDF 1.11; older versions of
  /// libsdformat keep the element but do not interpret it.
  bool read_mimic(const ::sdf::JointAxis& axis, const std::string& scope) {
    const ::sdf::ElementPtr mimic = axis.Element() ? axis.Element()->FindElement("mimic") : nullptr;
    if (!mimic) return true;
    const int line = mimic->LineNumber().value_or(1);
    const std::string whose = "the mimic of joint " + printable(into_.joints.back().name);
    following read{.line = line};
    const auto leader = mimic->GetAttribute("joint");
    if (!leader) return from_.fail(line, whose + " has no joint");
    const auto which = mimic->GetAttribute("axis");
    read.leader = scope + leader->GetAsString() + (which && which->GetAsString() == "axis2" ? "_2" : "");
    double reference = 0;
    for (const auto& [word, into] : {std::pair<const char*, double*>("multiplier", &read.multiplier),
                                     {"offset", &read.offset},
                                     {"reference", &reference}}) {
      const ::sdf::ElementPtr e = mimic->FindElement(word);
      if (!e || !e->GetValue()) continue;
      const std::string given = e->GetValue()->GetAsString();
      const auto number = urdf::number_in(given);
      if (!number)
        return from_.fail(line, "the " + std::string(word) + " of " + whose + " is not a finite number");
      *into = *number;
    }
    read.offset -= read.multiplier * reference;
    mimics_.emplace_back(into_.joints.size() - 1, read);
    return true;
  }

  urdf::document& from_;
  placed_links& links_;
  robot& into_;
  beginning begin_{};
  std::map<std::string, std::size_t> joints_{};
  std::vector<std::pair<std::size_t, following>> mimics_{};
};

} // namespace kanexpr::robots::sdf
