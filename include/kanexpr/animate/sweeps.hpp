#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/animate/path_of_cable.hpp>
#include <kanexpr/animate/profiles.hpp>

#include <array>
#include <cstddef>
#include <string_view>

/// Shapes along a smooth curve through several points, which bend with the model.
namespace kanexpr {

/// A place of a `sweep`: `Point`, with the curve along the vector `axis` there, and the profile rotating with
/// `Frame`. The x axis of the profile is perpendicular to `axis` and as close as possible to the frame's x
/// axis, or to its y axis if `axis` is within 30 degrees of x; z is along `axis`.
template <class Frame, class Point, auto axis>
struct station : animate::attached_along<Frame, Point, axis> {};

namespace animate {

template <class Place>
concept place_on_curve = requires {
  Place::varying;
  Place::axis;
  Place::point;
};

/// The attachment to several stations.
template <place_on_curve... Stations>
struct along_stations {
  static constexpr placement_kind placed_by = placement_kind::pose;
  static constexpr auto varying = joined<phrase>(Stations::varying...);
  static constexpr std::size_t places = sizeof...(Stations);
  static constexpr std::array<phrase, places> axes{Stations::axis...};
  static constexpr std::array<const describe::point_record*, places> points{&Stations::point...};
};

} // namespace animate

/// A solid with the given profile along a smooth curve through stations, such as a blade, a leaf spring or a
/// hose: `sweep<rectangle<b, h>, station<A, P, A::x>, station<B, Q, B::x>>`. Between the stations, the curve
/// is a cubic polynomial that keeps their positions and axes, and the profile rotates uniformly.
template <class Profile, class... Stations>
struct sweep;

template <animate::profile_of_sweep Profile, animate::place_on_curve... Stations>
struct sweep<Profile, Stations...> : animate::along_stations<Stations...> {
  static constexpr std::string_view shape = "sweep", profile = Profile::profile;
  static constexpr auto size_names = Profile::size_names;
  static constexpr auto sizes = Profile::sizes;
  using profile_type = Profile;
};

/// A round cable along a smooth curve through points, such as a rope of many bodies: `cable<0.01, O, P1,
/// P2>`; or a cable along a pathway, through its points or around its surface: `cable<0.01, through<P, A,
/// Q>>`.
template <auto radius, class... Points>
struct cable {
  static constexpr std::string_view shape = "cable", profile = "circle";
  static constexpr std::array<std::string_view, 1> size_names{"radius"};
  static constexpr auto sizes = animate::phrases_of<radius>;
  static constexpr animate::placement_kind placed_by = animate::placement_kind::place;
  static constexpr std::size_t places = sizeof...(Points);
  static constexpr std::array<animate::phrase, places> varying{animate::place<Points>...};
  static constexpr std::array<const describe::point_record*, places> points{&describe::point_of<Points>...};
};

template <auto radius, animate::pathway_of_cable Path>
struct cable<radius, Path> : animate::along_path<Path> {
  static constexpr std::string_view shape = "cable", profile = "circle";
  static constexpr std::array<std::string_view, 1> size_names{"radius"};
  static constexpr auto sizes = animate::phrases_of<radius>;
};

} // namespace kanexpr
