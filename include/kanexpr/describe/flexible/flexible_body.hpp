#pragma once

#include <kanexpr/describe/beams/amplitude_symbols.hpp>
#include <kanexpr/describe/body.hpp>
#include <kanexpr/describe/flexible/flexible_body_data.hpp>
#include <kanexpr/describe/flexible_record.hpp>
#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace kanexpr {

namespace describe {

template <class Data>
inline constexpr bool is_flexible_body_data = false;
template <int... counts>
inline constexpr bool is_flexible_body_data<flexible_body_data<counts...>> = true;

template <class Body>
inline constexpr flexible_record flexible_of = Body::flexible_description();

/// A flexible body, put together from its words.
template <class Self, class Reference, class Frame, const auto& given, class... Words>
struct flexible_body_of_words : body_words, amplitude_symbols<Self, Words...> {
  using base_point = Reference;
  using base_frame = Frame;
  static constexpr bool has_data = is_flexible_body_data<std::remove_cvref_t<decltype(given)>>;
  static constexpr const auto& data = given;
  static constexpr std::size_t coordinates_count = [] {
    if constexpr (has_data)
      return static_cast<std::size_t>(given.amplitudes_count);
    else
      return std::size_t{0};
  }();
  static constexpr std::size_t speeds_count = coordinates_count;

  static constexpr body_record content() {
    body_record r;
    r.called = type_name<Self>();
    r.declared_name = r.called;
    r.center = &point_of<Reference>;
    r.frame = &frame_of<Frame>;
    r.flexible = &flexible_of<Self>;
    return r;
  }

  static constexpr flexible_record flexible_description() {
    flexible_record r;
    r.mistake = mistake_of_words();
    if constexpr (has_data && coordinates_count < 100) {
      flexible_body_of_words::list_symbols(r);
      r.data = [] { return given.values(); };
    }
    return r;
  }

private:
  static constexpr std::string_view mistake_of_words() {
    if constexpr (!has_data) return "is not given by flexible_body_data<amplitudes, nodes>";
    if (coordinates_count > 99) return "has more than 99 amplitudes; build such a body at run time";
    if (!(is_joint_word<Words, joint_word::by> && ...))
      return "has an argument that is not one of its words; the only word is by<...>";
    if (sizeof...(Words) > 1) return "has by<...> twice";
    if (flexible_body_of_words::has_other_count())
      return "has by<...> with too few or too many symbols; write a coordinate for each amplitude, followed "
             "by a speed for each";
    if constexpr (has_data && coordinates_count < 100) return given.mistake_of_elasticity();
    return {};
  }
};

} // namespace describe

/// A body that deforms, given by numbers: `struct Panel : flexible_body<Panel, O, B, panel::data> {};` The
/// deformation is relative to the frame `B`, and positions are measured from the point `O`, which is fixed in
/// this frame. The numbers are a constant of type `flexible_body_data`, as `kanexpr_add_flexible_body` writes
/// it from a file. Each amplitude is a coordinate, q1_Panel, with the speed u1_Panel = dq1_Panel/dt, unless
/// `by<…>` names other symbols. List the body in `bodies<…>`; the coordinates of flexible bodies follow those
/// of the system, its joints and its beams.
///
/// The equations follow, without further approximation, from the kinetic energy to the second order in the
/// amplitudes and their rates. Wallrapp (1994), Standardization of flexible body modeling in multibody system
/// codes.
template <class Self, class Reference, class Frame, const auto& data, class... Words>
struct flexible_body : describe::flexible_body_of_words<Self, Reference, Frame, data, Words...> {};

} // namespace kanexpr
