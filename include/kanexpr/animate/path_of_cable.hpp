#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/token.hpp>
#include <kanexpr/numeric/parts_on_surface.hpp>

#include <array>
#include <concepts>
#include <cstddef>

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

} // namespace kanexpr::animate
