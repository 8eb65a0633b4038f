#pragma once

#include <kanexpr/animate/phrases.hpp>
#include <kanexpr/animate/placement.hpp>

/// The attachments of shapes to a model. `moving` are the numbers that determine the placement at each time.
namespace kanexpr::animate {

/// Attachment to a point.
template <class Point>
struct at {
  static constexpr phrases<1> moving{place<Point>};
  static constexpr placing placed_by = placing::place;
  static constexpr const describe::point_record* points[]{&describe::point_of<Point>};
};

/// Attachment to a point, rotating with a frame.
template <class Frame, class Point>
struct attached : at<Point> {
  static constexpr phrases<3> moving{place<Point>, x_of<Frame>, y_of<Frame>};
  static constexpr placing placed_by = placing::pose;
};

/// Attachment to a point, rotating with a frame, with the axis along a vector of the model.
template <class Frame, class Point, auto vector>
struct attached_along : at<Point> {
  static constexpr placing placed_by = placing::pose;
  static constexpr phrase axis = describe::phrase_of<vector>;
  static constexpr phrases<4> moving{place<Point>, axis, x_of<Frame>, y_of<Frame>};
};

/// Attachment between two points whose distance may change.
template <class From, class To>
struct between {
  static constexpr phrases<2> moving{place<From>, place<To>};
  static constexpr placing placed_by = placing::ends;
  static constexpr const describe::point_record* points[]{&describe::point_of<From>, &describe::point_of<To>};
};

} // namespace kanexpr::animate
