#pragma once

#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/point_builder.hpp>
#include <kanexpr/runtime/building/wheel_data.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// A wheel and the ground below it; the functions of a builder return it.
using wheel_on_ground = mechanics::wheel_on_ground;

/// The wheels of a builder and the ground below them.
class wheel_builder : private builder_part {
public:
  /// A wheel on the plane through `in_plane`, whose normal points to the wheel; the plane is fixed in the
  /// frame in whose axes the normal is given.
  wheel_on_ground wheel_on_plane(const wheel_data& wheel, point_id in_plane, const vector& normal);
  /// A wheel on the ground z = f(x, y), with coordinates from `origin` in the axes of a frame:
  /// `[&](expression x, expression y) { return h * cos(k * x); }`. The lowest point follows from `steps` of
  /// Newton's method.
  template <class Height>
  wheel_on_ground wheel_on_surface(const wheel_data& wheel, point_id origin, frame_id of,
                                   const Height& height, int steps = 2) {
    const mechanics::components at = mechanics::surface_coordinates(*m_.g);
    return wheel_on_height(wheel, origin, of, height(at.x, at.y), steps);
  }
  /// A conical wheel on a straight rail.
  wheel_on_ground wheel_on_rail(const wheel_data& wheel, const rail_data& rail);
  /// The distance by which the undeformed wheel overlaps the ground, in m; negative if the wheel is above.
  expression penetration_of(const wheel_on_ground& wheel);
  /// The point of a wheel that is deepest in the ground, on flat ground its lowest, as a material point of
  /// the wheel. The wheel touches the ground at this point if its `penetration_of` is zero, and rolls without
  /// slip if the velocity of the point is that of the ground.
  point_id contact_point(std::string_view called, const wheel_on_ground& wheel);

protected:
  explicit wheel_builder(builder_core& core, point_builder& points) : builder_part(core), points_(points) {}
  ~wheel_builder() = default;

private:
  /// Whether a wheel is of this builder and has no mistake.
  bool is_right(std::string_view asking, const wheel_on_ground& wheel);
  wheel_on_ground wheel_on(const wheel_data& wheel, point_id ground);
  wheel_on_ground wheel_on_height(const wheel_data& wheel, point_id origin, frame_id of, expression height,
                                  int steps);

  point_builder& points_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/wheel_builder.ipp>
#endif
