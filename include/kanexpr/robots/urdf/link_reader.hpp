#pragma once

#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::robots::urdf {

inline bool read_inertial(document& from, const element& e, const std::string& whose, link& into) {
  inertial read;
  if (!from.read_origin(e, read.center, "the mass center of " + whose)) return false;
  from.note_unknown_elements(e, {"origin", "mass", "inertia"}, "the <inertial> element of " + whose);
  const element* const mass = from.single_child(e, "mass", whose);
  const element* const inertia = from.single_child(e, "inertia", whose);
  if (!mass || !mass->Attribute("value"))
    return from.fail(e, whose + " has an <inertial> element without a mass");
  if (!from.read(*mass, "value", read.mass, "the mass of " + whose)) return false;
  from.note_unknown_attributes(*mass, {"value"}, "the mass of " + whose);
  if (inertia) {
    inertia_matrix& i = read.inertia;
    const std::string of = "the inertia of " + whose;
    from.note_unknown_attributes(*inertia, {"ixx", "iyy", "izz", "ixy", "iyz", "ixz"}, of);
    for (const char* moment : {"ixx", "iyy", "izz"})
      if (!inertia->Attribute(moment))
        from.note(*inertia, of + " has no " + moment + ", which is taken as 0");
    if (!from.read(*inertia, "ixx", i.xx, of) || !from.read(*inertia, "iyy", i.yy, of) ||
        !from.read(*inertia, "izz", i.zz, of) || !from.read(*inertia, "ixy", i.xy, of) ||
        !from.read(*inertia, "iyz", i.yz, of) || !from.read(*inertia, "ixz", i.zx, of))
      return false;
  } else if (read.mass > 0) {
    from.note(e, whose + " has a mass but no inertia and is treated as a particle");
  }
  const inertial_findings findings = check_inertial(read, whose);
  const element& at = inertia && read.mass >= 0 ? *inertia : *mass;
  if (!findings.mistake.empty()) return from.fail(at, findings.mistake);
  if (!findings.note.empty()) from.note(at, findings.note);
  into.inertial = read;
  return true;
}

inline bool read_shape(document& from, const element& e, const std::string& whose, std::vector<shape>& into) {
  const element* const geometry = e.FirstChildElement("geometry");
  const element* const is = geometry ? geometry->FirstChildElement() : nullptr;
  if (!is) return from.note(e, whose + " has a shape without a geometry, which is ignored"), true;
  shape read;
  const std::string_view kind = is->Name();
  const std::string of = "the " + printable(kind) + " of " + whose;
  if (!from.read_origin(e, read.origin, of)) return false;
  bool taken = true;
  if (kind == "box") {
    taken = from.read(*is, "size", read.size, of);
  } else if (kind == "sphere") {
    read.kind = shape_kind::sphere;
    taken = from.read(*is, "radius", read.size[0], of);
  } else if (kind == "cylinder" || kind == "capsule") {
    read.kind = kind == "capsule" ? shape_kind::capsule : shape_kind::cylinder;
    taken = from.read(*is, "radius", read.size[0], of) && from.read(*is, "length", read.size[1], of);
  } else if (kind == "mesh") {
    read.kind = shape_kind::mesh;
    read.size = {1, 1, 1};
    if (const char* file = is->Attribute("filename")) read.file = file;
    taken = from.read(*is, "scale", read.size, of);
  } else {
    from.note(*is, of + " is an unsupported shape and is ignored");
    return true;
  }
  if (taken) into.push_back(std::move(read));
  return taken;
}

inline bool read_link(document& from, const element& e, link& into) {
  const auto name = from.text(e, "name", "a link");
  if (!name) return false;
  into.name = *name;
  const std::string whose = "link " + printable(into.name);
  from.note_unknown_elements(
      e, {"inertial", "visual", "collision", "contact", "sensor", "self_collision_checking", "verbose"},
      whose);
  if (const element* inertial = from.single_child(e, "inertial", whose))
    if (!read_inertial(from, *inertial, whose, into)) return false;
  for (const element* s : children(e, "visual"))
    if (!read_shape(from, *s, whose, into.visual)) return false;
  for (const element* s : children(e, "collision"))
    if (!read_shape(from, *s, whose, into.collision)) return false;
  return true;
}

} // namespace kanexpr::robots::urdf
