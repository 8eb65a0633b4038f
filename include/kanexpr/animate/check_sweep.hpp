#pragma once

#include <kanexpr/animate/check_shape.hpp>
#include <kanexpr/animate/profiles.hpp>
#include <kanexpr/animate/sweeps.hpp>
#include <kanexpr/base/sentence.hpp>

#include <cstddef>
#include <string_view>

/// Checks for mistakes in a sweep or a cable.
namespace kanexpr::animate {

/// Checks that a curve passes through at least two places.
constexpr sentence check_places(std::size_t places, std::string_view place, std::string_view whom) {
  if (places > 1) return {};
  return sentence({"the ", whom, places == 0 ? " has no " : " has one ", place, places == 0 ? "s" : "",
                   "; it needs at least two"});
}

/// Checks that a profile is one.
template <class Profile>
constexpr sentence check_is_profile(std::string_view whose) {
  if constexpr (profile_of_sweep<Profile>)
    return {};
  else
    return sentence({"the profile of ", whose, " is ", template_name<Profile>(),
                     "; it must be a profile such as circle<radius>"});
}

/// Checks that the two ends of a tapered profile have the same form.
template <class Profile>
constexpr sentence check_profile(std::string_view whom) {
  if constexpr (requires { Profile::last_profile; })
    if (Profile::profile != Profile::last_profile)
      return sentence({"the profile of the ", whom, " changes from ", Profile::profile, " to ",
                       Profile::last_profile, "; both ends must have the same form"});
  return {};
}

/// Checks that the pathway of a cable has a place.
constexpr sentence check_path_of_cable(const describe::path_record& r, std::string_view whom) {
  if (r.what == describe::path_word::given_length)
    return sentence(
        {"the picture shows a cable along a pathway of which only the length is given; it has no place"});
  if (!r.fits)
    return sentence({"the pathway of the ", whom,
                     r.fits.missing > 0 ? " lacks a point" : " has too many points", "; write ",
                     r.fits.form});
  sentence found;
  if (r.frame != nullptr) found = check_vector(r.axis, "the axis of the surface of the ", whom);
  if (!found && r.center != nullptr) found = check_size(r.size, "size of the surface", whom);
  return found;
}

template <class Shape>
constexpr sentence check_curve(std::string_view whom) {
  if constexpr (requires { Shape::path; }) {
    return check_path_of_cable(Shape::path, whom);
  } else if constexpr (requires { Shape::axes; }) {
    sentence found = check_places(Shape::places, "station", whom);
    if (!found) found = check_profile<typename Shape::profile_type>(whom);
    for (const phrase& axis : Shape::axes)
      if (!found) found = check_vector(axis, "an axis of the ", whom);
    return found;
  } else {
    return check_places(Shape::places, "point", whom);
  }
}

template <class Profile, class... Stations>
struct misused_as_shape<sweep<Profile, Stations...>> {
  static constexpr sentence mistake() {
    sentence found = check_is_profile<Profile>("a sweep");
    ((found = found || place_on_curve<Stations>
                  ? found
                  : sentence({"a sweep passes through ", template_name<Stations>(),
                              ", which is not a station<frame, point, axis>"})),
     ...);
    return found;
  }
};

} // namespace kanexpr::animate
