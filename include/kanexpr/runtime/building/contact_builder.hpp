#pragma once

#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/contact_data.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

/// The contacts of a builder.
class contact_builder : private builder_part {
public:
  /// A contact of a sphere that is fixed in the frame `of` with the plane through `in_plane`, whose normal
  /// points to the sphere; the plane is fixed in the frame in whose axes the normal is given.
  void sphere_on_plane(point_id center, frame_id of, const number_or_expression& radius, point_id in_plane,
                       const vector& normal, const contact_data& data);
  /// The same for a point.
  void point_on_plane(point_id point, point_id in_plane, const vector& normal, const contact_data& data);
  /// The same for a torus: the centers of its tube are on a circle about the axis. The contact is undefined
  /// if the axis is parallel to the normal.
  void torus_on_plane(point_id center, frame_id of, const vector& axis, const number_or_expression& circle,
                      const number_or_expression& tube, point_id in_plane, const vector& normal,
                      const contact_data& data);
  /// A contact of two spheres outside of each other, each of which is fixed in a frame.
  void sphere_on_sphere(point_id center, frame_id of, const number_or_expression& radius,
                        point_id other_center, frame_id other, const number_or_expression& other_radius,
                        const contact_data& data);

  /// A contact of a point with a surface that is fixed in a frame. `level` is a function of three
  /// coordinates, which are measured from `origin` in the axes of the frame; it vanishes on the surface and
  /// is positive on the side of the point: `[&](expression x, expression y, expression z) { return z - h *
  /// sin(x); }`.
  template <class Level>
  void point_on_surface(point_id point, point_id origin, frame_id of, const Level& level,
                        const contact_data& data) {
    const mechanics::components at = mechanics::surface_coordinates(*m_.g);
    add_surface_contact(point, origin, of, level(at.x, at.y, at.z), data);
  }

  /// The normal force of a contact, numbered from 1 in the order in which contacts were added.
  expression normal_force_of(int contact, mechanics::known_motion& known);
  /// The friction force of a contact on its first body.
  vector friction_force_of(int contact, mechanics::known_motion& known);

protected:
  explicit contact_builder(builder_core& core) : builder_part(core) {}
  ~contact_builder() = default;

private:
  void add_surface_contact(point_id point, point_id origin, frame_id of, expression level,
                           const contact_data& data);
  void add_contact(const mechanics::contact_geometry& between, const contact_data& data);
  bool has_contact(int numbered, const mechanics::known_motion& known);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/contact_builder.ipp>
#endif
