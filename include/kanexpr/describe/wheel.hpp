#pragma once

#include <kanexpr/describe/diagnostics/misplaced_type.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/operators.hpp>
#include <kanexpr/describe/point.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/surface.hpp>
#include <kanexpr/describe/wheel_record.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>

#include <string_view>

/// Wheels and the ground on which they roll.
namespace kanexpr {

namespace describe {

template <class Center, class... Frame>
struct frame_of_wheel {
  using type = Center;
};
template <class Center, class Frame, class... Others>
struct frame_of_wheel<Center, Frame, Others...> {
  using type = Frame;
};

/// The frame of a wheel: the given one, or that of the center itself if it is a joint.
template <class Center, class... Frame>
using wheel_frame = typename frame_of_wheel<Center, Frame...>::type;

template <class Center, class... Frame>
constexpr void add_wheel(wheel_record& r, mechanics::rim_shape rim, const phrase& axis,
                         const phrase& radius) {
  r.rim = rim;
  r.center = &point_of<Center>;
  r.frame = &frame_of<wheel_frame<Center, Frame...>>;
  r.axis = axis, r.radius = radius;
  if (sizeof...(Frame) > 1) r.mistake = "has a wheel with two frames";
  if constexpr (sizeof...(Frame) == 0 && describe_kind<Center>() == point_out_of_place)
    r.mistake = "has a wheel whose center is a point; write its frame after the radius, as in "
                "thin_wheel<Center, axis, radius, Frame>";
}

/// From the center of a wheel to its lowest point above a plane. The radius of the tube is omitted for a thin
/// wheel.
template <auto axis, auto normal, auto circle, auto... tube>
inline constexpr auto to_lowest_point = [] {
  constexpr auto down = circle * normalized(dot(normal, axis) * axis - dot(axis, axis) * normal);
  if constexpr (sizeof...(tube) == 0)
    return down;
  else
    return down - (tube * ... * normalized(normal));
}();

template <class Wheel, class Ground>
constexpr wheel_record record_wheel() {
  using enum mechanics::rim_shape;
  wheel_record r;
  if constexpr (requires { Wheel::add_to(r); }) {
    Wheel::add_to(r);
  } else {
    r.mistake = "begins with neither thin_wheel<...>, toroidal_wheel<...> nor conical_wheel<...>";
    return r;
  }
  const std::string_view of_wheel = r.mistake;
  if constexpr (requires { Ground::lie_under(r); })
    Ground::lie_under(r);
  else
    r.mistake = "names no ground; after the wheel, write flat_ground<...>, uneven_ground<...> or "
                "straight_rail<...>";
  if (!of_wheel.empty()) r.mistake = of_wheel;
  if (!r.mistake.empty()) return r;
  const bool is_on_rail = r.ground == mechanics::ground_shape::rail;
  if (r.rim == conical && !is_on_rail)
    r.mistake = "has a conical_wheel<...> on other ground than straight_rail<...>, where it would touch "
                "along a line";
  if (r.rim == toroidal && is_on_rail)
    r.mistake = "has a wheel on a straight_rail<...> that is no conical_wheel<...>";
  return r;
}

/// Whether the lowest point of a wheel can be written as an offset.
template <class Wheel, class Ground>
concept is_in_closed_form = requires {
  typename Wheel::rim_in_closed_form;
  Ground::upward;
};

/// The record of a wheel and its ground.
template <class Wheel, class Ground>
inline constexpr wheel_record wheel_of = record_wheel<Wheel, Ground>();

/// A wheel and its ground in place of a load.
template <class Wheel, class Ground>
inline constexpr load_record wheel_as_load{.what = load_word::none, .wheel = &wheel_of<Wheel, Ground>};

template <class Wheel, class Ground>
constexpr token of_wheel(load_quantity what) {
  return of_load(what, &wheel_as_load<Wheel, Ground>,
                 !is_known_to_all_files<Wheel> || !is_known_to_all_files<Ground>);
}

template <class Wheel>
concept is_wheel = requires(wheel_record r) {
  typename Wheel::center;
  Wheel::add_to(r);
};

/// From the center of a wheel to its lowest point above any ground.
template <class Wheel, class Ground>
constexpr auto lowest_point() {
  if constexpr (is_in_closed_form<Wheel, Ground>)
    return Wheel::template to_lowest<Ground>;
  else
    return vector<1>{{of_wheel<Wheel, Ground>(load_quantity::lowest_point)}};
}

} // namespace describe

/// A wheel with a thin rim, a circle of the given radius about the axis: `thin_wheel<Wheel, Wheel::y, R>` if
/// Wheel is a joint, which is both a point and a frame; `thin_wheel<Center, Fork::y, R, W>` for a wheel whose
/// center is a point of the frame W. The axis points to the left of the wheel, so that it rolls forward with
/// a positive angular velocity; it may be given in the axes of a frame that does not spin.
template <class Center, auto axis, auto radius, class... Frame>
struct thin_wheel {
  using center = Center;
  using frame = describe::wheel_frame<Center, Frame...>;
  using rim_in_closed_form = Center;
  template <class Ground>
  static constexpr auto to_lowest = describe::to_lowest_point<axis, Ground::upward, radius>;

  static constexpr void add_to(describe::wheel_record& r) {
    describe::add_wheel<Center, Frame...>(r, mechanics::rim_shape::toroidal, describe::phrase_of<axis>,
                                          describe::phrase_of<radius>);
    r.tube = describe::no_phrase;
  }
};

/// A wheel with a round rim, such as a tyre of a bicycle: a tube with a circular section, whose center line
/// is a circle about the axis. `toroidal_wheel<Wheel, Wheel::y, radius of the circle, radius of the tube>`; a
/// frame may follow, as for `thin_wheel`.
template <class Center, auto axis, auto circle, auto tube, class... Frame>
struct toroidal_wheel {
  using center = Center;
  using frame = describe::wheel_frame<Center, Frame...>;
  using rim_in_closed_form = Center;
  template <class Ground>
  static constexpr auto to_lowest = describe::to_lowest_point<axis, Ground::upward, circle, tube>;

  static constexpr void add_to(describe::wheel_record& r) {
    describe::add_wheel<Center, Frame...>(r, mechanics::rim_shape::toroidal, describe::phrase_of<axis>,
                                          describe::phrase_of<circle>);
    r.tube = describe::phrase_of<tube>;
  }
};

/// A conical wheel of a railway vehicle: `conical_wheel<Center, Axle::y, r, lambda, Axle>`. The radius is r
/// at the center and grows by the conicity λ, the tangent of the angle of the cone, with the distance along
/// the axis. For a left wheel, whose radius grows toward the middle of the track, λ is negative.
template <class Center, auto axis, auto radius, auto conicity, class... Frame>
struct conical_wheel {
  using center = Center;
  using frame = describe::wheel_frame<Center, Frame...>;

  static constexpr void add_to(describe::wheel_record& r) {
    describe::add_wheel<Center, Frame...>(r, mechanics::rim_shape::conical, describe::phrase_of<axis>,
                                          describe::phrase_of<radius>);
    r.conicity = describe::phrase_of<conicity>;
  }
};

/// The plane through a point, whose normal points to the wheel: `flat_ground<O, N::z>`. The plane is fixed in
/// the frame in whose axes the normal is given.
template <class Place, auto normal>
struct flat_ground {
  static constexpr auto upward = normal;

  static constexpr void lie_under(describe::wheel_record& r) {
    r.ground = mechanics::ground_shape::flat;
    r.place = &describe::point_of<Place>;
    r.normal = describe::phrase_of<normal>;
  }
};

/// The surface z = f(x, y), with coordinates from a point in the axes of a frame: `uneven_ground<O, N,
/// h*cos(k*surface::x)>`. The lowest point of the wheel is found by a fixed number of Newton's steps, which
/// may follow f; the default is 2. The ground must be less curved than the wheel.
template <class Place, class Frame, auto height, int steps = 2>
struct uneven_ground {
  static constexpr void lie_under(describe::wheel_record& r) {
    r.ground = mechanics::ground_shape::uneven;
    r.place = &describe::point_of<Place>;
    r.ground_frame = &describe::frame_of<Frame>;
    r.height = describe::phrase_of<height>;
    r.steps = steps;
    if (steps < 0 || steps > 9)
      r.mistake = "has an uneven_ground<...> with a number of steps outside of 0 to 9";
  }
};

/// A straight rail for a conical wheel: `straight_rail<Place, N::x, N::z, R>`. The point is on the uppermost
/// line of its head, which is a circular cylinder of the radius R; the directions are along the rail and up.
/// If the radius is omitted, the rail is that line.
template <class Place, auto along, auto up, auto... head>
struct straight_rail {
  static constexpr void lie_under(describe::wheel_record& r) {
    r.ground = mechanics::ground_shape::rail;
    r.place = &describe::point_of<Place>;
    r.along = describe::phrase_of<along>;
    r.normal = describe::phrase_of<up>;
    r.head = describe::given_phrases<head...>[0];
    if (sizeof...(head) > 1) r.mistake = "has a straight_rail<...> with more than one radius";
  }
};

/// The point of a wheel that is deepest in the ground, on flat ground its lowest, as a material point of the
/// wheel: `struct C : contact_point<C, thin_wheel<Hub, Fork::y, R, W>, flat_ground<O, N::z>> {};` The wheel
/// touches the ground at this point if its `penetration_of` is zero, and rolls without slip if the velocity
/// of the point is that of the ground.
template <class Self, class Wheel, class Ground>
struct contact_point {
  static_assert(describe::is_wheel<Wheel>, "contact_point<Self, Wheel, Ground> requires a thin_wheel<...>, "
                                           "toroidal_wheel<...> or conical_wheel<...>");
};
template <class Self, class Wheel, class Ground>
  requires describe::is_wheel<Wheel>
struct contact_point<Self, Wheel, Ground>
    : offset<Self, typename Wheel::center, describe::lowest_point<Wheel, Ground>()>,
      fixed_in<typename Wheel::frame> {};

/// The distance by which an undeformed wheel overlaps the ground, in m; negative if the wheel is above:
/// `configuration_constraints<penetration_of<toroidal_wheel<...>, uneven_ground<...>> == 0>`. It depends only
/// on coordinates and parameters.
template <class Wheel, class Ground>
inline constexpr scalar<1> penetration_of{
    {describe::of_wheel<Wheel, Ground>(describe::load_quantity::penetration)}};

} // namespace kanexpr
