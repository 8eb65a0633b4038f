#pragma once

#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace kanexpr::animate {

/// The places along a pathway, from the numbers of an attachment.
inline numeric::taut_line line_of(const describe::path_record& r, const double* numbers) {
  const auto next = [&numbers] {
    const Eigen::Vector3d v(numbers[0], numbers[1], numbers[2]);
    numbers += 3;
    return v;
  };
  if (r.center == nullptr) {
    std::vector<Eigen::Vector3d> places;
    places.reserve(static_cast<std::size_t>(r.points.size));
    for (int i = 0; i < r.points.size; ++i) places.push_back(next());
    return numeric::straight_lines(std::move(places));
  }
  using enum describe::path_word;
  numeric::wrapped_surface s;
  s.form = r.what == sphere     ? numeric::wrapped_solid::sphere
           : r.what == cylinder ? numeric::wrapped_solid::cylinder
                                : numeric::wrapped_solid::cone;
  s.sense = r.sense == wrapping::counterclockwise ? 1 : -1;
  s.first_is_on_surface = r.first_is_on_surface, s.last_is_on_surface = r.last_is_on_surface;
  const Eigen::Vector3d first = next();
  s.center = next();
  const Eigen::Vector3d last = next();
  if (r.frame != nullptr) s.axis = next().normalized();
  s.size = *numbers;
  return numeric::line_around(s, first, last);
}

} // namespace kanexpr::animate
