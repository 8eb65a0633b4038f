#pragma once

#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/pulling_load.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <vector>

namespace kanexpr::runtime {

/// A line along which loads act, such as a cable; the functions of a builder return it.
using pathway = mechanics::pathway;

/// An end of a pathway around a surface: a point, which may lie on the surface.
struct end_of_path {
  point_id point{};
  bool is_on_surface = false;
  end_of_path(point_id p, bool on_surface = false) : point(p), is_on_surface(on_surface) {}
};

/// The pathways of a builder and the loads along them; a positive tension shortens a pathway.
class pathway_builder : private builder_part {
public:
  pathway straight(point_id from, point_id to) { return through({from, to}); }
  /// Straight lines from point to point, between which a cable slides without friction.
  pathway through(const std::vector<point_id>& points);
  /// A pathway of which only the length is given, such as the coordinate of a joint.
  pathway given_length(expression length);
  /// An end of a pathway that lies on the surface around which the pathway is wrapped.
  static end_of_path on_surface(point_id p) { return {p, true}; }
  /// The shortest line around a cylinder that is fixed in the frame `in`.
  pathway around_cylinder(frame_id in, point_id on_axis, const vector& axis, expression radius,
                          end_of_path first, end_of_path last, wrapping sense);
  pathway around_sphere(point_id center, expression radius, end_of_path first, end_of_path last);
  /// The shortest line around a cone with the given angle between the axis, which points from the tip into
  /// the cone, and the surface.
  pathway around_cone(frame_id in, point_id tip, const vector& axis, expression angle, end_of_path first,
                      end_of_path last, wrapping sense);
  /// The length of a pathway.
  expression length_of(const pathway& along);

  pulling_load force_along(const pathway& along, expression tension);
  /// A spring with the tension stiffness·(length − natural length).
  pulling_load linear_spring(const pathway& along, expression stiffness, expression natural_length);
  pulling_load linear_spring(const pathway& along, expression stiffness) {
    return linear_spring(along, stiffness, m_.zero());
  }
  /// A spring with the tension k x + k₃ x³, where x is the length minus the natural length.
  pulling_load cubic_spring(const pathway& along, expression k, expression k3, expression natural_length);
  pulling_load cubic_spring(const pathway& along, expression k, expression k3) {
    return cubic_spring(along, k, k3, m_.zero());
  }
  pulling_load linear_damper(const pathway& along, expression damping);
  /// Friction against the rate of the length.
  pulling_load friction_along(const pathway& along, expression normal_force,
                              const mechanics::friction_law& law);
  /// Stops at a least and at a greatest length, as `stop<Path, …>`.
  pulling_load stop(const pathway& along, expression least, expression greatest, expression stiffness,
                    expression damping) {
    return stop(along, least, greatest, stiffness, damping,
                mechanics::default_width_of_stop(least, greatest));
  }
  pulling_load stop(const pathway& along, expression least, expression greatest, expression stiffness,
                    expression damping, expression width);

  /// The tension of a load that one of these functions, `spring`, `damper` or `muscle` returned; it is
  /// positive if the load pulls the ends together. If the length is an angle, it is a torque.
  expression tension_of(const pulling_load& load, mechanics::known_motion& known);

protected:
  explicit pathway_builder(builder_core& core) : builder_part(core) {}
  ~pathway_builder() = default;

private:
  bool owns_load(const mechanics::spring_damper& load);
  bool owns_load(const mechanics::path_load& load);
  bool owns_load(const mechanics::muscle& load);
  pulling_load add_spring(const pathway& along, expression k, expression k3, expression natural_length);
  /// A pathway around a surface of revolution, or around a sphere if the axis is zero.
  pathway around_surface(mechanics::pathway_form form, frame_id in, point_id center, const vector& axis,
                         expression size, end_of_path first, end_of_path last, wrapping sense);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/pathway_builder.ipp>
#endif
