#pragma once

#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/pose.hpp>
#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <ignition/math/Pose3.hh>
#include <ignition/math/Vector3.hh>
#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Collision.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Element.hh>
#include <sdf/Geometry.hh>
#include <sdf/Link.hh>
#include <sdf/Mesh.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <kanexpr/base/letters_aside.hpp>

/// Converts links and poses of libsdformat, which stores poses with quaternions; right angles are made exact.
namespace kanexpr::robots::sdf {

inline vector3 vector_of(const ignition::math::Vector3d& v) {
  return {v.X() + 0.0, v.Y() + 0.0, v.Z() + 0.0};
}

/// The position in a pose. Entries below a picometer, rounding errors of the conversion to quaternions,
/// become 0.
inline vector3 position_of(const ignition::math::Vector3d& v, double tolerance) {
  vector3 place = vector_of(v);
  if (tolerance > 0)
    for (double& e : place) e = std::abs(e) < 1e-12 ? 0 : e;
  return place;
}

inline rotation rotation_of(const ignition::math::Quaterniond& q, double tolerance) {
  return round_right_angles(rotation_by_quaternion(q.X(), q.Y(), q.Z(), q.W()), tolerance);
}

inline pose pose_of(const ignition::math::Pose3d& p, double tolerance) {
  return {rotation_of(p.Rot(), tolerance), position_of(p.Pos(), tolerance)};
}

/// Returns the line in the file; 1 for elements that libsdformat created.
template <class Entity>
int line_of(const Entity& e) {
  return e.Element() ? e.Element()->LineNumber().value_or(1) : 1;
}

/// Returns the shape of a geometry if it is supported.
inline std::optional<shape> shape_of(const ::sdf::Geometry& g) {
  shape s;
  if (const ::sdf::Box* box = g.BoxShape()) {
    s.size = vector_of(box->Size());
  } else if (const ::sdf::Cylinder* cylinder = g.CylinderShape()) {
    s.kind = shape_kind::cylinder, s.size = {cylinder->Radius(), cylinder->Length(), 0};
  } else if (const ::sdf::Capsule* capsule = g.CapsuleShape()) {
    s.kind = shape_kind::capsule, s.size = {capsule->Radius(), capsule->Length(), 0};
  } else if (const ::sdf::Sphere* sphere = g.SphereShape()) {
    s.kind = shape_kind::sphere, s.size = {sphere->Radius(), 0, 0};
  } else if (const ::sdf::Mesh* mesh = g.MeshShape()) {
    s.kind = shape_kind::mesh, s.size = vector_of(mesh->Scale()), s.file = mesh->Uri();
  } else {
    return {};
  }
  return s;
}

class link_reader {
public:
  explicit link_reader(urdf::document& from) : from_(from) {}

  bool read(const ::sdf::Link& l, const std::string& called, link& into) {
    into.name = called;
    if (!read_inertial(l, into)) return false;
    for (std::uint64_t i = 0; i < l.VisualCount(); ++i) read_shape(*l.VisualByIndex(i), into, into.visual);
    for (std::uint64_t i = 0; i < l.CollisionCount(); ++i)
      read_shape(*l.CollisionByIndex(i), into, into.collision);
    return true;
  }

private:
  bool read_inertial(const ::sdf::Link& l, link& into) {
    const std::string whose = "link " + printable(into.name);
    const auto& mass = l.Inertial().MassMatrix();
    inertial read;
    read.mass = mass.Mass();
    read.center = pose_of(l.Inertial().Pose(), from_.tolerance());
    read.inertia = {mass.Ixx(), mass.Iyy(), mass.Izz(), mass.Ixy(), mass.Iyz(), mass.Ixz()};
    note_defaults(l, whose);
    const inertial_findings findings = check_inertial(read, whose);
    if (!findings.mistake.empty()) return from_.fail(line_of(l), findings.mistake);
    if (!findings.note.empty()) from_.note(line_of(l), findings.note);
    into.inertial = read;
    return true;
  }

  void note_defaults(const ::sdf::Link& l, const std::string& whose) {
    const ::sdf::ElementPtr given =
        l.Element() && l.Element()->HasElement("inertial") ? l.Element()->GetElement("inertial") : nullptr;
    if (!given)
      return from_.note(
          line_of(l),
          whose + " has no <inertial> element; the default of SDF is 1 kg and 1 kg m^2 about each axis");
    if (!given->HasElement("mass"))
      from_.note(line_of(l), whose + " has no mass; the default of SDF is 1 kg");
    if (!given->HasElement("inertia"))
      from_.note(line_of(l), whose + " has no inertia; the default of SDF is 1 kg m^2 about each axis");
  }

  template <class Seen>
  void read_shape(const Seen& seen, const link& of, std::vector<shape>& into) {
    ignition::math::Pose3d placed;
    std::optional<shape> s = seen.Geom() ? shape_of(*seen.Geom()) : std::nullopt;
    if (!s || !seen.SemanticPose().Resolve(placed).empty())
      return from_.note(line_of(seen),
                        "link " + printable(of.name) + " has an unsupported shape, which is ignored");
    s->origin = pose_of(placed, from_.tolerance());
    into.push_back(std::move(*s));
  }

  urdf::document& from_;
};

} // namespace kanexpr::robots::sdf

#include <kanexpr/base/letters_back.hpp>
