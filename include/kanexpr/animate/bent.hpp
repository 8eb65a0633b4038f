#pragma once

#include <kanexpr/animate/check_shape.hpp>
#include <kanexpr/animate/check_sweep.hpp>
#include <kanexpr/animate/profiles.hpp>
#include <kanexpr/animate/sweeps.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/beams/section.hpp>
#include <kanexpr/describe/frame.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

/// The shape of a beam of the model.
namespace kanexpr {

namespace animate {

/// A section of a beam at which a picture evaluates its position and orientation.
template <class Beam, std::size_t index, std::size_t last>
struct section_in_picture
    : section<section_in_picture<Beam, index, last>, Beam, static_cast<double>(index) / last> {};

/// The axis of a beam in the axes of a section.
template <class Beam, class Section>
inline constexpr auto axis_at_section =
    describe::in_axes_of(&describe::frame_of<Section>, Beam::direction_of_axis);

template <class Beam, class Section>
using station_of_beam = station<Section, Section, axis_at_section<Beam, Section>>;

template <class Beam, class Indices>
struct along_beam;
template <class Beam, std::size_t... index>
struct along_beam<Beam, std::index_sequence<index...>>
    : along_stations<station_of_beam<Beam, section_in_picture<Beam, index, sizeof...(index) - 1>>...> {};

} // namespace animate

/// A beam of the model, bent as it moves: `show<bent<Blade, rectangle<b, h>>>`. Its profile passes through
/// `stations` equally spaced sections of the beam, at least two.
template <class Beam, class Profile, std::size_t stations = 9>
struct bent;

template <describe::beam_without_mistake Beam, animate::profile_of_sweep Profile, std::size_t stations>
  requires(stations > 1)
struct bent<Beam, Profile, stations> : animate::along_beam<Beam, std::make_index_sequence<stations>> {
  static constexpr std::string_view shape = "beam", profile = Profile::profile, called = type_name<Beam>();
  static constexpr auto size_names = Profile::size_names;
  static constexpr auto sizes = Profile::sizes;
  using profile_type = Profile;
};

namespace animate {

template <class Beam, class Profile, std::size_t stations>
struct misused_as_shape<bent<Beam, Profile, stations>> {
  static constexpr sentence mistake() {
    if constexpr (!requires { Beam::is_written(); }) {
      return sentence({"the picture bends ", template_name<Beam>(), ", which is not a beam"});
    } else if constexpr (!Beam::is_written()) {
      return sentence({"the beam ", type_name<Beam>(), " ", Beam::beam_description().mistake});
    } else {
      base::name whom = "the beam ";
      whom.append(type_name<Beam>());
      const sentence found = check_is_profile<Profile>(whom.view());
      return found ? found : check_places(stations, "station", whom.view().substr(4));
    }
  }
};

} // namespace animate

} // namespace kanexpr
