#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>

#include <array>
#include <string_view>

namespace kanexpr::describe {

/// A wheel and the ground below it. Values that it does not have are empty phrases.
struct wheel_record {
  mechanics::rim_shape rim{};
  mechanics::ground_shape ground{};
  const point_record* center = nullptr;
  const frame_record* frame = nullptr;
  phrase axis{}, radius{}, tube{}, conicity{};
  const point_record* place = nullptr;        ///< a point of the ground
  const frame_record* ground_frame = nullptr; ///< null if it is the frame of the normal
  phrase normal{}, along{}, head{}, height{};
  int steps = 0;              ///< of Newton's method above an uneven ground
  std::string_view mistake{}; ///< the end of a sentence; empty if there is none
};

constexpr std::array<const phrase*, 8> phrases_of(const wheel_record& r) {
  return {&r.axis, &r.radius, &r.tube, &r.conicity, &r.normal, &r.along, &r.head, &r.height};
}

} // namespace kanexpr::describe
