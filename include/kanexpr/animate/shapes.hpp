#pragma once

#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/base/text.hpp>

#include <string_view>

/// Simple shapes, attached to the frames and points of a model. Sizes are numbers or expressions that contain
/// only parameters.
namespace kanexpr {

namespace animate {

/// The scales along x, y and z: three values, one value for all axes, or 1 by default.
template <auto... scales>
constexpr phrases<3> scales_of() {
  if constexpr (sizeof...(scales) == 0)
    return phrases_of<1, 1, 1>;
  else if constexpr (sizeof...(scales) == 3)
    return phrases_of<scales...>;
  else
    return [](const phrase& first, const auto&...) {
      return phrases<3>{first, first, first};
    }(describe::phrase_of<scales>...);
}

} // namespace animate

/// A box centered at `Point` with its edges along the axes of `Frame`.
template <class Frame, class Point, auto along_x, auto along_y, auto along_z>
struct box : animate::attached<Frame, Point> {
  static constexpr std::string_view shape = "box";
  static constexpr std::string_view size_names[]{"edge along x", "edge along y", "edge along z"};
  static constexpr auto sizes = animate::phrases_of<along_x, along_y, along_z>;
};

/// An ellipsoid centered at `Point` with its semi-axes along the axes of `Frame`.
template <class Frame, class Point, auto along_x, auto along_y, auto along_z>
struct ellipsoid : animate::attached<Frame, Point> {
  static constexpr std::string_view shape = "ellipsoid";
  static constexpr std::string_view size_names[]{"semi-axis along x", "semi-axis along y",
                                                 "semi-axis along z"};
  static constexpr auto sizes = animate::phrases_of<along_x, along_y, along_z>;
};

/// A sphere centered at `Point`.
template <class Point, auto radius>
struct sphere : animate::at<Point> {
  static constexpr std::string_view shape = "sphere";
  static constexpr std::string_view size_names[]{"radius"};
  static constexpr auto sizes = animate::phrases_of<radius>;
};

/// A cylinder centered at `Point` with its axis along the vector `axis`; marks on its ends show its rotation
/// with `Frame`.
template <class Frame, class Point, auto axis, auto radius, auto length>
struct cylinder : animate::attached_along<Frame, Point, axis> {
  static constexpr std::string_view shape = "cylinder";
  static constexpr std::string_view size_names[]{"radius", "length"};
  static constexpr auto sizes = animate::phrases_of<radius, length>;
};

/// A cone with its tip at `Point` that opens along the vector `axis`.
template <class Frame, class Point, auto axis, auto radius, auto length>
struct cone : animate::attached_along<Frame, Point, axis> {
  static constexpr std::string_view shape = "cone";
  static constexpr std::string_view size_names[]{"radius", "length"};
  static constexpr auto sizes = animate::phrases_of<radius, length>;
};

/// A torus with outer radius `radius` and tube diameter `thickness`.
template <class Frame, class Point, auto axis, auto radius, auto thickness>
struct ring : animate::attached_along<Frame, Point, axis> {
  static constexpr std::string_view shape = "ring";
  static constexpr std::string_view size_names[]{"radius", "thickness"};
  static constexpr auto sizes = animate::phrases_of<radius, thickness>;
};

/// A tire with outer radius `radius` and spokes, one of which has a different colour.
template <class Frame, class Point, auto axis, auto radius, auto thickness>
struct wheel : animate::attached_along<Frame, Point, axis> {
  static constexpr std::string_view shape = "wheel";
  static constexpr std::string_view size_names[]{"radius", "thickness"};
  static constexpr auto sizes = animate::phrases_of<radius, thickness>;
};

/// A rod between two points whose distance may change.
template <class From, class To, auto radius>
struct rod : animate::between<From, To> {
  static constexpr std::string_view shape = "rod";
  static constexpr std::string_view size_names[]{"radius"};
  static constexpr auto sizes = animate::phrases_of<radius>;
};

/// A coil spring between two points.
template <class From, class To, auto radius, auto turns>
struct coil : animate::between<From, To> {
  static constexpr std::string_view shape = "coil";
  static constexpr std::string_view size_names[]{"radius", "number of turns"};
  static constexpr auto sizes = animate::phrases_of<radius, turns>;
};

/// An arrow from `Point` along a vector of the model, such as a force or a velocity. The page shows it on
/// demand, and scales all arrows of a layer alike.
template <class Point, auto vector_of_model>
struct arrow : animate::at<Point> {
  static constexpr std::string_view shape = "arrow";
  static constexpr std::string_view layer = "Vectors";
  static constexpr animate::phrase vector = describe::phrase_of<vector_of_model>;
  static constexpr animate::phrases<2> varying{animate::place<Point>, vector};
  static constexpr animate::placement_kind placed_by = animate::placement_kind::ends;
  static constexpr animate::phrases<0> sizes{};
};

/// The axes of `Frame` as arrows from `Point`: x red, y green, z blue.
template <class Frame, class Point, auto length>
struct axes : animate::attached<Frame, Point> {
  static constexpr std::string_view shape = "axes";
  static constexpr std::string_view size_names[]{"length"};
  static constexpr auto sizes = animate::phrases_of<length>;
};

/// The mesh in an STL, COLLADA (.dae) or Wavefront OBJ file, with its origin at `Point` and its axes along
/// those of `Frame`, regardless of the up axis that the file declares. `scales` is one factor for all axes,
/// or one for each axis. Lengths are in meters unless the file declares a different unit. The file is
/// embedded in the page when the page is written. A relative name is resolved in the folder that `files_in`
/// specifies, by default in the current folder.
template <class Frame, class Point, text file_name, auto... scales>
struct mesh : animate::attached<Frame, Point> {
  static constexpr std::string_view shape = "mesh";
  static constexpr std::string_view file = file_name.view();
  static constexpr std::size_t scale_count = sizeof...(scales);
  static constexpr std::string_view size_names[]{"scale along x", "scale along y", "scale along z"};
  static constexpr auto sizes = animate::scales_of<scales...>();
};

} // namespace kanexpr
