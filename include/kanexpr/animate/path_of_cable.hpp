#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/token.hpp>
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

/// The pathways of a model as cables of a picture.
namespace kanexpr::animate {

template <class Path>
concept pathway_of_cable = requires {
  { Path::path } -> std::convertible_to<describe::path_record>;
};

/// The number of places of a cable along a pathway.
constexpr std::size_t places_of(const describe::path_record& r) {
  if (r.center == nullptr) return static_cast<std::size_t>(r.points.size);
  return numeric::parts_on_surface + 1 + (r.first_is_on_surface ? 0 : 1) + (r.last_is_on_surface ? 0 : 1);
}

/// The attachment of a cable to the points of a pathway: its ends, the points through which it passes, and
/// the center of the surface around which it is wrapped, which is second.
template <class Path>
struct along_path {
  static constexpr const describe::path_record& path = describe::path_of<Path>;
  static constexpr placement_kind placed_by = placement_kind::place;
  static constexpr std::size_t places = places_of(path);
  static constexpr bool is_wrapped = path.center != nullptr, has_axis = path.frame != nullptr;
  static constexpr std::size_t count = static_cast<std::size_t>(path.points.size) + (is_wrapped ? 1 : 0);
  static constexpr std::array<const describe::point_record*, count> points = [] {
    std::array<const describe::point_record*, count> all{};
    std::size_t next = 0;
    for (const describe::point_record& each : path.points) {
      all[next++] = &each;
      if (is_wrapped && next == 1) all[next++] = path.center;
    }
    return all;
  }();

private:
  static constexpr std::array<describe::token, count> positions = [] {
    std::array<describe::token, count> all{};
    for (std::size_t i = 0; i < count; ++i) {
      all[i] = describe::with(describe::token_kind::position);
      all[i].point = points[i];
    }
    return all;
  }();

public:
  /// The positions of the points; for a surface, also its axis and its size.
  static constexpr auto varying = [] {
    phrases<count + (has_axis ? 1 : 0) + (is_wrapped ? 1 : 0)> all{};
    std::size_t next = 0;
    for (const describe::token& each : positions) all[next++] = {describe::shape::vector, &each, 1};
    if constexpr (has_axis) all[next++] = path.axis;
    if constexpr (is_wrapped) all[next++] = path.size;
    return all;
  }();
};

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
