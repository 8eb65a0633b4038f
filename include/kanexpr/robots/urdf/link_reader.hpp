#pragma once

#include <kanexpr/robots/check_inertial.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::robots::urdf {

inline bool read_inertial(document& from, const element& e, const std::string& whose, link& into) {
  inertial read;
  if (!from.take_origin(e, read.center, "the mass center of " + whose)) return false;
  from.know_elements(e, {"origin", "mass", "inertia"}, "the <inertial> element of " + whose);
  const element* const mass = from.only(e, "mass", whose);
  const element* const inertia = from.only(e, "inertia", whose);
  if (!mass || !mass->Attribute("value"))
    return from.fail(e, whose + " has an <inertial> element without a mass");
  if (!from.take(*mass, "value", read.mass, "the mass of " + whose)) return false;
  from.know(*mass, {"value"}, "the mass of " + whose);
  if (inertia) {
    inertia_matrix& i = read.inertia;
    const std::string of = "the inertia of " + whose;
    from.know(*inertia, {"ixx", "iyy", "izz", "ixy", "iyz", "ixz"}, of);
    for (const char* moment : {"ixx", "iyy", "izz"})
      if (!inertia->Attribute(moment))
        from.note(*inertia, of + " has no " + moment + ", which is taken as 0");
    if (!from.take(*inertia, "ixx", i.xx, of) || !from.take(*inertia, "iyy", i.yy, of) ||
        !from.take(*inertia, "izz", i.zz, of) || !from.take(*inertia, "ixy", i.xy, of) ||
        !from.take(*inertia, "iyz", i.yz, of) || !from.take(*inertia, "ixz", i.zx, of))
      return false;
  } else if (read.mass > 0) {
    from.note(e, whose + " has a mass but no inertia and is treated as a particle");
  }
  const inertial_remarks remarks = remarks_on(read, whose);
  const element& at = inertia && read.mass >= 0 ? *inertia : *mass;
  if (!remarks.mistake.empty()) return from.fail(at, remarks.mistake);
  if (!remarks.note.empty()) from.note(at, remarks.note);
  into.inertial = read;
  return true;
}

inline bool read_shape(document& from, const element& e, const std::string& whose, std::vector<shape>& into) {
  const element* const geometry = e.FirstChildElement("geometry");
  const element* const is = geometry ? geometry->FirstChildElement() : nullptr;
  if (!is) return from.note(e, whose + " has a shape without a geometry, which is ignored"), true;
  shape read;
  const std::string_view kind = is->Name();
  const std::string of = "the " + shown(kind) + " of " + whose;
  if (!from.take_origin(e, read.placed, of)) return false;
  bool taken = true;
  if (kind == "box") {
    taken = from.take(*is, "size", read.size, of);
  } else if (kind == "sphere") {
    read.is = shape_kind::sphere;
    taken = from.take(*is, "radius", read.size[0], of);
  } else if (kind == "cylinder" || kind == "capsule") {
    read.is = kind == "capsule" ? shape_kind::capsule : shape_kind::cylinder;
    taken = from.take(*is, "radius", read.size[0], of) && from.take(*is, "length", read.size[1], of);
  } else if (kind == "mesh") {
    read.is = shape_kind::mesh;
    read.size = {1, 1, 1};
    if (const char* file = is->Attribute("filename")) read.file = file;
    taken = from.take(*is, "scale", read.size, of);
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
  const std::string whose = "link " + shown(into.name);
  from.know_elements(
      e, {"inertial", "visual", "collision", "contact", "sensor", "self_collision_checking", "verbose"},
      whose);
  if (const element* inertial = from.only(e, "inertial", whose))
    if (!read_inertial(from, *inertial, whose, into)) return false;
  for (const element* s = e.FirstChildElement("visual"); s; s = s->NextSiblingElement("visual"))
    if (!read_shape(from, *s, whose, into.visual)) return false;
  for (const element* s = e.FirstChildElement("collision"); s; s = s->NextSiblingElement("collision"))
    if (!read_shape(from, *s, whose, into.collision)) return false;
  return true;
}

} // namespace kanexpr::robots::urdf
