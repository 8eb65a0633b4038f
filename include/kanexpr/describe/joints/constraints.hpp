#pragma once

#include <kanexpr/describe/constraint.hpp>
#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/motion.hpp>

/// Constraints that are common in machines, for `configuration_constraints<…>` or `velocity_constraints<…>`.
namespace kanexpr {

namespace describe {

/// The default for an omitted argument.
struct left_out {};

/// Returns a placeholder for a constraint that contains a mistake.
template <class Named>
constexpr equation<1> invalid_constraint(misuse what) {
  return {{misused_with<Named>(what)}};
}

/// An equation between the coordinates of two joints with one axis each.
template <class First, class Second>
constexpr auto coupled(const auto& of_first, const auto& of_second) {
  if constexpr (effort_of_joint<First>() == joint_effort::none ||
                effort_of_joint<Second>() == joint_effort::none) {
    return invalid_constraint<First>(misuse::coupling);
  } else if constexpr (std::same_as<First, Second>) {
    return invalid_constraint<First>(misuse::self_coupling);
  } else {
    return of_first * First::template q<0> == of_second * Second::template q<0>;
  }
}

template <class First, class Second, auto... ratio>
constexpr auto gear_equation() {
  if constexpr (sizeof...(ratio) == 1)
    return coupled<First, Second>(constant(1), ratio...);
  else
    return invalid_constraint<First>(misuse::gear_arguments);
}
template <class First, class Second, auto... radii>
constexpr auto belt_equation() {
  if constexpr (sizeof...(radii) == 2)
    return coupled<First, Second>(radii...);
  else
    return invalid_constraint<First>(misuse::belt_arguments);
}
template <class Rack, class Pinion, auto... radius>
constexpr auto rack_equation() {
  if constexpr (sizeof...(radius) == 1)
    return coupled<Rack, Pinion>(constant(1), whole_argument(radius)...);
  else
    return invalid_constraint<Rack>(misuse::rack_arguments);
}

/// Requires the components of a direction along the other two axes of a frame to vanish.
template <auto direction, auto axis>
constexpr auto kept_parallel() {
  if constexpr (requires { requires sizeof(axis.tokens) == sizeof(token); }) {
    constexpr token t = axis.tokens[0];
    if constexpr (t.what == token_kind::basis && t.frame != nullptr)
      return zero_along<direction, basis(t.frame, (t.index + 1) % 3, t.is_of_one_file),
                        basis(t.frame, (t.index + 2) % 3, t.is_of_one_file)>;
    else
      return invalid_constraint<left_out>(misuse::parallel);
  } else {
    return invalid_constraint<left_out>(misuse::parallel);
  }
}
template <auto... direction_and_axis>
constexpr auto parallelism() {
  if constexpr (sizeof...(direction_and_axis) == 2)
    return kept_parallel<direction_and_axis...>();
  else
    return invalid_constraint<left_out>(misuse::parallel_arguments);
}

/// The axis of a wheel, marked so that the phrase reader checks it.
template <class Wheel, auto axis>
constexpr auto axis_of_wheel() {
  if constexpr (requires { requires shape_of_operand<decltype(unit_along(axis))> == shape::vector; }) {
    token t = with(token_kind::wheel_axis);
    t.frame = parts_of<Wheel>::frame();
    t.is_of_one_file = !is_known_to_all_files<Wheel>;
    return joined<shape::vector>(t, unit_along(axis));
  } else {
    return unit_along(axis);
  }
}

/// The component of a plane's normal `up` within the plane of the wheel, which points from the contact
/// towards the center.
template <class Wheel, auto axis, auto up>
inline constexpr auto up_the_wheel = up - dot(up, axis_of_wheel<Wheel, axis>()) * unit_along(axis);

/// Returns a radius or the length of a rod as an expression.
template <auto given>
constexpr auto length_of() {
  if constexpr (plain_number<decltype(given)>)
    if (given < 0) return scalar<1>{{misused(misuse::negative_length)}};
  if constexpr (!plain_number<decltype(given)> && shape_of_operand<decltype(given)> == shape::scalar)
    return joined<shape::scalar>(with(token_kind::length), operand(given));
  else if constexpr (plain_number<decltype(given)>)
    return whole_argument(given);
  else
    return operand(given);
}

/// Returns the vector from the center of a wheel to its contact with a plane.
template <class Wheel, auto axis, auto up, auto radius, auto... tube>
constexpr auto to_contact() {
  if constexpr (sizeof...(tube) == 0)
    return -length_of<radius>() * normalized(up_the_wheel<Wheel, axis, up>);
  else
    return -length_of<radius>() * normalized(up_the_wheel<Wheel, axis, up>) -
           length_of<one_of<0, tube...>()>() * up;
}

template <class Wheel, auto up, auto axis, auto radius, auto... tube>
constexpr auto height_of_center() {
  if constexpr (sizeof...(tube) == 0)
    return length_of<radius>() * magnitude(up_the_wheel<Wheel, axis, up>);
  else
    return length_of<radius>() * magnitude(up_the_wheel<Wheel, axis, up>) + length_of<one_of<0, tube...>()>();
}

template <class Place>
constexpr auto velocity_of_place() {
  return motion_of(token_kind::velocity, parts_of<Place>::point(), !is_known_to_all_files<Place>);
}
template <class Place>
constexpr auto turning_of_place() {
  return motion_of(token_kind::angular_velocity, parts_of<Place>::frame(), !is_known_to_all_files<Place>);
}
template <class Place, class From>
constexpr auto position_between() {
  return motion_of(token_kind::position, parts_of<Place>::point(), !is_known_to_all_files<Place>) -
         motion_of(token_kind::position, parts_of<From>::point(), !is_known_to_all_files<From>);
}

/// Returns an axis of a frame, or of the frame that a type contains.
template <class Frame>
constexpr vector<1> axis_of(int index) {
  return basis(parts_of<Frame>::frame(), index, !is_known_to_all_files<Frame>);
}

/// Returns the velocity, relative to `Ground`, of the material point of `Wheel` that touches it.
template <class Wheel, class Ground, auto axis, auto... radii>
constexpr auto slip_on() {
  constexpr auto to_ground = to_contact<Wheel, axis, axis_of<Ground>(2), radii...>();
  constexpr auto of_wheel = velocity_of_place<Wheel>() + cross(turning_of_place<Wheel>(), to_ground);
  if constexpr (parts_of<Ground>::frame()->is_inertial() && parts_of<Ground>::point()->is_origin())
    return of_wheel;
  else
    return of_wheel - velocity_of_place<Ground>() -
           cross(turning_of_place<Ground>(), position_between<Wheel, Ground>() + to_ground);
}

template <class Point, class Other, auto... length>
constexpr auto distance_equation() {
  if constexpr (sizeof...(length) == 1)
    return dot(position_of<Point, Other>, position_of<Point, Other>) ==
           length_of<length...>() * length_of<length...>();
  else
    return invalid_constraint<Point>(misuse::rod_arguments);
}

template <class Point, class Other, auto... directions>
constexpr auto coincidence() {
  if constexpr (std::same_as<Other, left_out>)
    return invalid_constraint<Point>(misuse::coincident_arguments);
  else
    return zero_along<position_of<Point, Other>, directions...>;
}

template <class Frame, class Other>
constexpr auto alignment() {
  if constexpr (std::same_as<Other, left_out>)
    return invalid_constraint<Frame>(misuse::same_axes_arguments);
  else
    return zero_along<dot(axis_of<Frame>(0), axis_of<Other>(1)) * axis_of<Other>(0) +
                          dot(axis_of<Frame>(1), axis_of<Other>(2)) * axis_of<Other>(1) +
                          dot(axis_of<Frame>(2), axis_of<Other>(0)) * axis_of<Other>(2),
                      axis_of<Other>(0), axis_of<Other>(1), axis_of<Other>(2)>;
}

/// Whether the arguments are the axis of a wheel, its radius and, for a torus, the radius of its tube.
template <auto... axis_and_radii>
inline constexpr bool describe_wheel = sizeof...(axis_and_radii) == 2 || sizeof...(axis_and_radii) == 3;

template <class Wheel, class Ground, auto... axis_and_radii>
constexpr auto rolling() {
  if constexpr (describe_wheel<axis_and_radii...>)
    return zero_along<slip_on<Wheel, Ground, axis_and_radii...>(), axis_of<Ground>(0), axis_of<Ground>(1),
                      axis_of<Ground>(2)>;
  else
    return invalid_constraint<Wheel>(misuse::rolling_arguments);
}

template <class Wheel, class Ground, auto... axis_and_radii>
constexpr auto touching() {
  if constexpr (describe_wheel<axis_and_radii...>)
    return dot(position_between<Wheel, Ground>(), axis_of<Ground>(2)) ==
           height_of_center<Wheel, axis_of<Ground>(2), axis_and_radii...>();
  else
    return invalid_constraint<Wheel>(misuse::touch_arguments);
}

} // namespace describe

/// Keeps two points at a fixed distance, like the ends of a massless rod: `rod_of_length<P, Q, l>`, a
/// configuration constraint. Its multiplier times −2 l is the tension.
template <class Point, class Other = describe::left_out, auto... length>
inline constexpr auto rod_of_length = describe::distance_equation<Point, Other, length...>();

/// A configuration constraint that couples two gears: the first joint turns `ratio` times as far as the
/// second, in the opposite direction if the ratio is negative.
template <class First, class Second = describe::left_out, auto... ratio>
inline constexpr auto gear = describe::gear_equation<First, Second, ratio...>();

/// A configuration constraint for a belt around two pulleys: the products of radius and angle are equal; for
/// a crossed belt, one radius is negative.
template <class First, class Second = describe::left_out, auto... radii>
inline constexpr auto belt = describe::belt_equation<First, Second, radii...>();

/// A configuration constraint by which a sliding joint moves as far as the rim of a turning one:
/// `rack_and_pinion<Rack, Pinion, r>`.
template <class Rack, class Pinion = describe::left_out, auto... radius>
inline constexpr auto rack_and_pinion = describe::rack_equation<Rack, Pinion, radius...>();

/// A configuration constraint that makes two points coincide, which closes a loop with a ball joint:
/// `coincident<P, Q, N::x, N::y, N::z>`. A planar mechanism needs only two directions.
template <class Point, class Other = describe::left_out, auto... directions>
inline constexpr auto coincident = describe::coincidence<Point, Other, directions...>();

/// A configuration constraint that keeps a direction parallel to an axis of a frame: `parallel<A::z, B::z>`.
/// Together with `coincident`, it closes a loop with a pin about B::z.
template <auto... direction_and_axis>
inline constexpr auto parallel = describe::parallelism<direction_and_axis...>();

/// A configuration constraint that keeps the axes of two frames aligned: `same_axes<A, B>`. Together with
/// `coincident`, it closes a loop with a weld. Half turns about an axis and rotations that permute the axes
/// satisfy it as well, so the motion must start with aligned axes.
template <class Frame, class Other = describe::left_out>
inline constexpr auto same_axes = describe::alignment<Frame, Other>();

/// A velocity constraint by which a wheel rolls without slipping on the plane x, y of `Ground`, which may
/// itself move: `rolls_on<Wheel, Ground, Wheel::y, r>`, with the axis and radius of the wheel and, if it is a
/// torus, the radius of its tube. `Wheel` is a joint or a `frame_and_point<A, P>` in which P is its center;
/// `Ground` also has a frame and a point.
template <class Wheel, class Ground = describe::left_out, auto... axis_and_radii>
inline constexpr auto rolls_on = describe::rolling<Wheel, Ground, axis_and_radii...>();

/// A configuration constraint by which a wheel touches the plane x, y of `Ground`; it takes the arguments of
/// `rolls_on`.
template <class Wheel, class Ground = describe::left_out, auto... axis_and_radii>
inline constexpr auto touches = describe::touching<Wheel, Ground, axis_and_radii...>();

} // namespace kanexpr
