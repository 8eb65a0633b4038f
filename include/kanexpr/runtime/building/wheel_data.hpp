#pragma once

#include <kanexpr/runtime/building/builder_checks.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>

namespace kanexpr::runtime {

/// A wheel of a builder: a body of revolution about an axis, which points to its left.
struct wheel_data {
  point_id center{};
  frame_id frame{};
  vector axis{};
  number_or_expression radius;         ///< of the rim, or of the circle of the centers of its tube
  number_or_expression tube = 0.0;     ///< the radius of the tube of a round rim
  number_or_expression conicity = 0.0; ///< of a wheel on a rail: the slope of its radius along the axis
};

/// A straight rail of a builder, whose head is a circular cylinder.
struct rail_data {
  point_id on_top{}; ///< a point of its uppermost line
  vector along{}, up{};
  number_or_expression radius = 0.0; ///< of the head
};

} // namespace kanexpr::runtime
