#pragma once

#include <kanexpr/animate/look.hpp>
#include <kanexpr/animate/shapes.hpp>

#include <string_view>

/// The elements of a picture. Of the phrases of an element, `moving` is evaluated at each time, `still` is
/// evaluated once, and `rates` are integrated over time.
namespace kanexpr {

/// A shape that moves with the model.
template <class Shape, class... Options>
struct show {};

template <class Shape, class... Options>
  requires requires { Shape::shape; }
struct show<Shape, Options...> {
  static constexpr std::string_view word = "show";
  static constexpr animate::look look = animate::look_of<Options...>();
  using attachment = Shape;
  static constexpr auto moving = Shape::moving;
  static constexpr auto still = Shape::sizes;
  static constexpr auto rates = animate::spin_of<Options...>();
};

/// The path of a point up to the time shown.
template <class Point, class... Options>
struct trace {
  static constexpr std::string_view word = "trace";
  static constexpr animate::look look = animate::look_of<Options...>();
  using attachment = animate::at<Point>;
  static constexpr auto moving = attachment::moving;
  static constexpr animate::phrases<0> still{};
  static constexpr animate::phrases<0> rates{};
};

/// The up direction: any constant vector, evaluated at the first time.
template <auto vector>
struct up {
  static constexpr std::string_view word = "up";
  static constexpr std::string_view vector_name = "direction";
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<vector>;
  static constexpr animate::phrases<0> rates{};
};

/// The initial viewing direction: a vector from the system to the eye.
template <auto vector>
struct seen_from {
  static constexpr std::string_view word = "seen_from";
  static constexpr std::string_view vector_name = "direction";
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<vector>;
  static constexpr animate::phrases<0> rates{};
};

/// The ground, a plane perpendicular to `up`, `height` above the model's origin.
template <auto height = 0.0>
struct ground {
  static constexpr std::string_view word = "ground";
  static constexpr std::string_view size_names[]{"height"};
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<height>;
  static constexpr animate::phrases<0> rates{};
};

/// Makes the model travel over the ground: its origin moves perpendicular to `up` such that `Point` moves
/// with the velocity that the model gives it.
///
/// A rolling model may use the contact point as its origin, because the point of the wheel at the contact has
/// zero velocity, although the contact travels. With r the position of `Point` from the origin and v its
/// velocity, the displacement of the origin is ∫ v dt − (r − r(0)). The integral is evaluated by Simpson's
/// rule if the trajectory provides the state midway between two samples, else by the trapezoidal rule on the
/// samples.
template <class Point>
struct carried {
  static constexpr std::string_view word = "carried";
  static constexpr const describe::point_record* points[]{&describe::point_of<Point>};
  static constexpr animate::phrases<1> moving{animate::place<Point>};
  static constexpr animate::phrases<0> still{};
  static constexpr auto rates = animate::phrases_of<velocity_of<Point>>;
};

/// The folder of mesh files with relative names; `page_options::folder` overrides it for a single page.
template <text directory>
struct files_in {
  static constexpr std::string_view word = "files_in";
  static constexpr std::string_view folder = directory.view();
  static constexpr animate::phrases<0> moving{};
  static constexpr animate::phrases<0> still{};
  static constexpr animate::phrases<0> rates{};
};

} // namespace kanexpr
