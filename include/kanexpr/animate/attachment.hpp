#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/record.hpp>

#include <array>

/// The scalars and vectors of a model that a picture evaluates, and the attachments of shapes to frames and
/// points. The values in `varying` determine the placement at each time.
namespace kanexpr::animate {

using describe::phrase;
using describe::shape;

template <std::size_t size>
using phrases = std::array<phrase, size>;

constexpr int numbers_in(const phrase& p) { return p.kind == shape::vector ? 3 : 1; }

template <std::size_t size>
constexpr int numbers_in(const phrases<size>& list) {
  int sum = 0;
  for (const phrase& p : list) sum += numbers_in(p);
  return sum;
}

template <auto... expressions>
inline constexpr phrases<sizeof...(expressions)> phrases_of{describe::phrase_of<expressions>...};

/// The position of a point relative to its origin.
template <class Point>
inline constexpr phrase place = describe::phrase_of<describe::motion_of(
    describe::token_kind::position, &describe::point_of<Point>, !is_known_to_all_files<Point>)>;

/// Two axes of a frame; the third is their cross product.
template <class Frame>
inline constexpr phrase x_of =
    describe::phrase_of<describe::basis(&describe::frame_of<Frame>, 0, !is_known_to_all_files<Frame>)>;
template <class Frame>
inline constexpr phrase y_of =
    describe::phrase_of<describe::basis(&describe::frame_of<Frame>, 1, !is_known_to_all_files<Frame>)>;

/// Attachment to a point.
template <class Point>
struct at {
  static constexpr phrases<1> varying{place<Point>};
  static constexpr placement_kind placed_by = placement_kind::place;
  static constexpr const describe::point_record& point = describe::point_of<Point>;
  static constexpr const describe::point_record* points[]{&point};
};

/// Attachment to a point, rotating with a frame.
template <class Frame, class Point>
struct attached : at<Point> {
  static constexpr phrases<3> varying{place<Point>, x_of<Frame>, y_of<Frame>};
  static constexpr placement_kind placed_by = placement_kind::pose;
};

/// Attachment to a point, rotating with a frame, with the axis along a vector of the model.
template <class Frame, class Point, auto vector>
struct attached_along : at<Point> {
  static constexpr placement_kind placed_by = placement_kind::pose;
  static constexpr phrase axis = describe::phrase_of<vector>;
  static constexpr phrases<4> varying{place<Point>, axis, x_of<Frame>, y_of<Frame>};
};

/// Attachment between two points whose distance may change.
template <class From, class To>
struct between {
  static constexpr phrases<2> varying{place<From>, place<To>};
  static constexpr placement_kind placed_by = placement_kind::ends;
  static constexpr const describe::point_record* points[]{&describe::point_of<From>, &describe::point_of<To>};
};

} // namespace kanexpr::animate
