#pragma once

#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/animate/shapes.hpp>
#include <kanexpr/animate/sweeps.hpp>

#include <string_view>

namespace kanexpr {

namespace animate {

/// The appearance and the name of a shape.
struct look {
  std::string_view colour{}; ///< "#rrggbb"; if empty, the page chooses a colour
  std::string_view name{};   ///< if empty, formed from the kind and the place of the shape
  std::string_view layer{};  ///< the switch of the page that shows it; if empty, it is always shown
  std::string_view unit{};   ///< the unit of the length of an arrow
  double opacity = 1;
};

template <class Option>
concept option_of_shape = requires(look& l) { Option::apply_to(l); };

template <class Option>
constexpr void apply_option(look& l) {
  if constexpr (option_of_shape<Option>) Option::apply_to(l);
}

template <class... Options>
constexpr look look_of(std::string_view layer = {}) {
  look l;
  l.layer = layer;
  (apply_option<Options>(l), ...);
  return l;
}

/// The layer of a shape without the option `layer`.
template <class Shape>
constexpr std::string_view layer_of() {
  if constexpr (requires { Shape::layer; })
    return Shape::layer;
  else
    return {};
}

template <class Option, std::size_t size>
constexpr void put_spin(phrases<size>& found, std::size_t& next) {
  if constexpr (requires { Option::spin; }) found[next++] = Option::spin;
}

/// Returns the `spinning` option, if there is one.
template <class... Options>
constexpr auto spin_of() {
  phrases<(std::size_t{0} + ... + (requires { Options::spin; } ? 1 : 0))> found{};
  [[maybe_unused]] std::size_t next = 0;
  (put_spin<Options>(found, next), ...);
  return found;
}

/// An element of a picture. The expressions in `varying` are evaluated at each time, and those in `constant`
/// only once; those in `rates` are integrated over time.
struct element {
  static constexpr phrases<0> varying{}, constant{}, rates{};
};

} // namespace animate

/// The color of a shape: `show<sphere<P, 0.1>, colour<"#c0392b">>`.
template <text hexadecimal>
struct colour {
  static constexpr void apply_to(animate::look& l) { l.colour = hexadecimal.view(); }
};

/// The opacity, from 0 (invisible) to 1.
template <auto part>
struct opacity {
  static constexpr void apply_to(animate::look& l) { l.opacity = static_cast<double>(part); }
};

/// The name of a shape on the page, in place of a default such as "sphere at P".
template <text words>
struct named {
  static constexpr void apply_to(animate::look& l) { l.name = words.view(); }
};

/// Adds the shape to a layer, which the page shows on demand: `show<axes<A, P, 0.2>, layer<"Frames">>`.
template <text words>
struct layer {
  static constexpr void apply_to(animate::look& l) { l.layer = words.view(); }
};

/// The unit of the vector of an arrow.
template <text words>
struct unit {
  static constexpr void apply_to(animate::look& l) { l.unit = words.view(); }
};

/// Makes the shape rotate about its axis relative to its frame, at the rate `speed`, which is integrated
/// along the trajectory. Intended for wheels whose angle does not affect the motion and is therefore not a
/// coordinate of the model: `show<wheel<R, C, R::y, r, 0.04>, spinning<u3>>`.
template <auto speed>
struct spinning {
  static constexpr describe::phrase spin = describe::phrase_of<speed>;
  static constexpr void apply_to(animate::look&) {}
};

/// A shape that moves with the model.
template <class Shape, class... Options>
struct show {};

template <class Shape, class... Options>
  requires requires { Shape::shape; }
struct show<Shape, Options...> {
  static constexpr std::string_view word = "show";
  static constexpr animate::look look = animate::look_of<Options...>(animate::layer_of<Shape>());
  using attachment = Shape;
  static constexpr auto varying = Shape::varying;
  static constexpr auto constant = Shape::sizes;
  static constexpr auto rates = animate::spin_of<Options...>();
};

/// The path of a point up to the time shown.
template <class Point, class... Options>
struct trace : animate::element {
  static constexpr std::string_view word = "trace";
  static constexpr animate::look look = animate::look_of<Options...>();
  using attachment = animate::at<Point>;
  static constexpr auto varying = attachment::varying;
};

/// The up direction: any constant vector, evaluated at the first sample.
template <auto vector>
struct up : animate::element {
  static constexpr std::string_view word = "up";
  static constexpr std::string_view vector_name = "direction";
  static constexpr auto constant = animate::phrases_of<vector>;
};

/// The initial viewing direction: a vector from the system to the eye.
template <auto vector>
struct seen_from : animate::element {
  static constexpr std::string_view word = "seen_from";
  static constexpr std::string_view vector_name = "direction";
  static constexpr auto constant = animate::phrases_of<vector>;
};

/// The ground, a plane perpendicular to `up`, `height` above the model's origin.
template <auto height = 0.0>
struct ground : animate::element {
  static constexpr std::string_view word = "ground";
  static constexpr std::string_view size_names[]{"height"};
  static constexpr auto constant = animate::phrases_of<height>;
};

/// Makes the model travel over the ground: its origin moves perpendicular to `up` such that `Point` moves
/// with the velocity that the model gives it.
///
/// A rolling model may use the contact point as its origin, because the point of the wheel that touches the
/// ground has zero velocity, even though the contact point travels. With r the position of `Point` from the
/// origin and v its velocity, the displacement of the origin is ∫ v dt − (r − r(0)). The integral is
/// evaluated by Simpson's rule if the trajectory provides the state midway between two samples, else by the
/// trapezoidal rule on the samples.
template <class Point>
struct carried : animate::element {
  static constexpr std::string_view word = "carried";
  static constexpr const describe::point_record* points[]{&describe::point_of<Point>};
  static constexpr animate::phrases<1> varying{animate::place<Point>};
  static constexpr auto rates = animate::phrases_of<velocity_of<Point>>;
};

/// A scalar of the model that the page plots next to the coordinates, speeds and inputs:
/// `plot<"height of P", dot(position_of<P, O>, N::z), "m">`.
template <text called, auto scalar, text of_unit = "">
struct plot : animate::element {
  static constexpr std::string_view word = "plot";
  static constexpr std::string_view name = called.view(), unit = of_unit.view();
  static constexpr auto varying = animate::phrases_of<scalar>;
};

/// Plots the kinetic energy, the potential energy and their sum: `plot_energies<"J">`.
template <text of_unit = "">
struct plot_energies : animate::element {
  static constexpr std::string_view word = "plot_energies";
  static constexpr std::string_view unit = of_unit.view();
};

/// The unit of coordinates, speeds or inputs, which the page writes next to their names:
/// `in_unit<"rad", q1, q2>`.
template <text of_unit, auto... listed>
struct in_unit : animate::element {
  static constexpr std::string_view word = "in_unit";
  static constexpr std::string_view unit = of_unit.view();
  static constexpr auto symbols = animate::phrases_of<listed...>;
};

/// The forces among the loads of the model and the weights of its bodies, as arrows that the page shows on
/// demand: `show_forces<"N">`.
template <text of_unit = "">
struct show_forces : animate::element {
  static constexpr std::string_view word = "show_forces";
  static constexpr std::string_view unit = of_unit.view();
};

/// The velocities of the mass centers, as arrows that the page shows on demand: `show_velocities<"m/s">`.
template <text of_unit = "">
struct show_velocities : animate::element {
  static constexpr std::string_view word = "show_velocities";
  static constexpr std::string_view unit = of_unit.view();
};

/// The axes of the rigid bodies at their mass centers, which the page shows on demand.
struct show_frames : animate::element {
  static constexpr std::string_view word = "show_frames";
};

/// The folder for relative names of mesh files; `page_options::folder` overrides it for a single page.
template <text directory>
struct files_in : animate::element {
  static constexpr std::string_view word = "files_in";
  static constexpr std::string_view folder = directory.view();
};

} // namespace kanexpr
