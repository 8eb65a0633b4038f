#pragma once

#include <kanexpr/animate/look.hpp>
#include <kanexpr/animate/shapes.hpp>

/// The words of a picture. Of the phrases in a word, `moving` is evaluated at each time, `still` once and
/// `rates` are integrated over time.
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

/// The path of a point, drawn as far as it has come.
template <class Point, class... Options>
struct trace {
  static constexpr std::string_view word = "trace";
  static constexpr animate::look look = animate::look_of<Options...>();
  using attachment = animate::at<Point>;
  static constexpr auto moving = attachment::moving;
  static constexpr animate::phrases<0> still{};
  static constexpr animate::phrases<0> rates{};
};

/// Which way is up: any vector that does not change, as it is at the first time.
template <auto vector>
struct up {
  static constexpr std::string_view word = "up";
  static constexpr std::string_view vector_name = "direction";
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<vector>;
  static constexpr animate::phrases<0> rates{};
};

/// From where the picture is looked at in the beginning: a vector from the system to the eye.
template <auto vector>
struct seen_from {
  static constexpr std::string_view word = "seen_from";
  static constexpr std::string_view vector_name = "direction";
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<vector>;
  static constexpr animate::phrases<0> rates{};
};

/// The ground, a plane across `up`, `height` above the model's origin.
template <auto height = 0.0>
struct ground {
  static constexpr std::string_view word = "ground";
  static constexpr std::string_view size_names[]{"height"};
  static constexpr animate::phrases<0> moving{};
  static constexpr auto still = animate::phrases_of<height>;
  static constexpr animate::phrases<0> rates{};
};

/// The model travels over the ground: its origin moves, across `up`, so that `Point` has its velocity.
///
/// A rolling model may measure positions from the contact, which it takes for an origin because that point of
/// the wheel has no velocity, though the contact travels. With r the position of `Point` from the origin and
/// v its velocity, the origin has come the way ∫ v dt − (r − r(0)). The integral is Simpson's, with the state
/// halfway between two samples where the trajectory gives it, else the trapezoidal rule on the samples.
template <class Point>
struct carried {
  static constexpr std::string_view word = "carried";
  static constexpr const describe::point_record* points[]{&describe::point_of<Point>};
  static constexpr animate::phrases<1> moving{animate::place<Point>};
  static constexpr animate::phrases<0> still{};
  static constexpr auto rates = animate::phrases_of<velocity_of<Point>>;
};

/// Where the files of meshes with relative names are; `page_options::folder` says it for a page alone.
template <text directory>
struct files_in {
  static constexpr std::string_view word = "files_in";
  static constexpr std::string_view folder = directory.view();
  static constexpr animate::phrases<0> moving{};
  static constexpr animate::phrases<0> still{};
  static constexpr animate::phrases<0> rates{};
};

} // namespace kanexpr
