#pragma once

#include <kanexpr/describe/constraint.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/joints/joint.hpp>

/// Constraints of machines, to be written in `configuration_constraints<…>` or `velocity_constraints<…>`.
namespace kanexpr {

namespace describe {

/// An equation between what two joints with one axis have turned or gone.
template <class First, class Second>
constexpr auto coupled(const auto& of_first, const auto& of_second) {
  if constexpr (effort_of_joint<First>() == joint_effort::none ||
                effort_of_joint<Second>() == joint_effort::none) {
    token named = misused(misuse::coupling);
    if constexpr (requires { First::child_frame(); }) named.frame = First::child_frame();
    return equation<1>{{named}};
  } else if constexpr (std::same_as<First, Second>) {
    token named = misused(misuse::own_coupling);
    named.frame = First::child_frame();
    return equation<1>{{named}};
  } else {
    return of_first * First::template q<0> == of_second * Second::template q<0>;
  }
}

/// A direction that has no part along the other two axes of a frame.
template <auto direction, auto axis>
constexpr auto kept_parallel() {
  if constexpr (requires { requires sizeof(axis.tokens) == sizeof(token); }) {
    constexpr token t = axis.tokens[0];
    if constexpr (t.what == token_kind::basis && t.frame != nullptr)
      return zero_along<direction, basis(t.frame, (t.index + 1) % 3), basis(t.frame, (t.index + 2) % 3)>;
    else
      return equation<1>{{misused(misuse::parallel)}};
  } else {
    return equation<1>{{misused(misuse::parallel)}};
  }
}

constexpr vector<1> velocity_at(const point_record* point) { return motion_of(token_kind::velocity, point); }
constexpr vector<1> turning_of(const frame_record* frame) {
  return motion_of(token_kind::angular_velocity, frame);
}

/// The way from a plane whose normal is `up` towards the middle of a wheel, in the plane of the wheel.
template <auto axis, auto up>
inline constexpr auto up_the_wheel = up - dot(up, unit_along(axis)) * unit_along(axis);

/// A radius or the length of a rod as an expression.
template <auto given>
constexpr auto length_of() {
  if constexpr (plain_number<decltype(given)>)
    if (given < 0) return scalar<1>{{misused(misuse::negative_length)}};
  return operand(given);
}

/// From the centre of a wheel to where it touches a plane.
template <auto axis, auto up, auto radius, auto... tube>
constexpr auto to_contact() {
  if constexpr (sizeof...(tube) == 0)
    return -length_of<radius>() * normalized(up_the_wheel<axis, up>);
  else
    return -length_of<radius>() * normalized(up_the_wheel<axis, up>) - length_of<one_of<0, tube...>()>() * up;
}

template <auto axis, auto up, auto radius, auto... tube>
constexpr auto height_of_center() {
  if constexpr (sizeof...(tube) == 0)
    return length_of<radius>() * magnitude(up_the_wheel<axis, up>);
  else
    return length_of<radius>() * magnitude(up_the_wheel<axis, up>) + length_of<one_of<0, tube...>()>();
}

template <class Place>
constexpr auto velocity_of_place() {
  return velocity_at(parts_of<Place>::point());
}
template <class Place>
constexpr auto turning_of_place() {
  return turning_of(parts_of<Place>::frame());
}
template <class Place, class From>
constexpr auto position_between() {
  return motion_of(token_kind::position, parts_of<Place>::point()) -
         motion_of(token_kind::position, parts_of<From>::point());
}

/// The velocity of the point of `Wheel` that touches `Ground`, as that sees it.
template <class Wheel, class Ground, auto axis, auto... radii>
constexpr auto slip_on() {
  constexpr auto to_ground = to_contact<axis, Ground::z, radii...>();
  constexpr auto of_wheel = velocity_of_place<Wheel>() + cross(turning_of_place<Wheel>(), to_ground);
  if constexpr (parts_of<Ground>::frame()->is_inertial() && parts_of<Ground>::point()->is_origin())
    return of_wheel;
  else
    return of_wheel - velocity_of_place<Ground>() -
           cross(turning_of_place<Ground>(), position_between<Wheel, Ground>() + to_ground);
}

} // namespace describe

/// Two points stay at a distance, as the ends of a rod without mass: `rod_of_length<P, Q, l>`, of the
/// configuration. Its multiplier times −2 l is the tension.
template <class Point, class Other, auto length>
inline constexpr auto rod_of_length = dot(position_of<Point, Other>, position_of<Point, Other>) ==
                                      describe::length_of<length>() * describe::length_of<length>();

/// Two gears: the first joint has turned `ratio` times as far as the second, against it where the ratio is
/// negative. Of the configuration.
template <class First, class Second, auto ratio>
inline constexpr auto gear = describe::coupled<First, Second>(describe::constant(1), ratio);

/// A belt round two pulleys: radius times angle is the same; of a crossed belt one radius is negative. Of
/// the configuration.
template <class First, class Second, auto radius, auto other_radius>
inline constexpr auto belt = describe::coupled<First, Second>(radius, other_radius);

/// A joint that slides goes as far as the rim of one that turns: `rack_and_pinion<Rack, Pinion, r>`, of the
/// configuration.
template <class Rack, class Pinion, auto radius>
inline constexpr auto rack_and_pinion = describe::coupled<Rack, Pinion>(describe::constant(1), radius);

/// Two points are one, which closes a loop by a ball: `coincident<P, Q, N::x, N::y, N::z>`, along two
/// directions in a planar mechanism. Of the configuration.
template <class Point, class Other, auto... directions>
inline constexpr auto coincident = zero_along<position_of<Point, Other>, directions...>;

/// A direction stays along an axis of a frame: `parallel<A::z, B::z>`. Beside `coincident` it closes a loop
/// by a pin about B::z. Of the configuration.
template <auto direction, auto axis>
inline constexpr auto parallel = describe::kept_parallel<direction, axis>();

/// The axes of two frames stay the same: `same_axes<A, B>`. Beside `coincident` it closes a loop by a weld.
/// Of the configuration. (Half a turn about an axis and turns that exchange the axes satisfy it as well:
/// start where the axes are the same.)
template <class Frame, class Other>
inline constexpr auto same_axes =
    zero_along<dot(Frame::x, Other::y) * Other::x + dot(Frame::y, Other::z) * Other::y +
                   dot(Frame::z, Other::x) * Other::z,
               Other::x, Other::y, Other::z>;

/// A wheel rolls on the plane x, y of `Ground` without slipping, which may move itself: `rolls_on<Wheel,
/// Ground, Wheel::y, r>`, with its axis, and after the radius that of its tube, if it is a torus. Of the
/// velocity. `Wheel` is a joint or `frame_and_point<A, P>` with its centre.
template <class Wheel, class Ground, auto axis, auto radius, auto... tube>
inline constexpr auto rolls_on =
    zero_along<describe::slip_on<Wheel, Ground, axis, radius, tube...>(), Ground::x, Ground::y, Ground::z>;

/// A wheel touches the plane x, y of `Ground`: the same, of the configuration.
template <class Wheel, class Ground, auto axis, auto radius, auto... tube>
inline constexpr auto touches = dot(describe::position_between<Wheel, Ground>(), Ground::z) ==
                                describe::height_of_center<axis, Ground::z, radius, tube...>();

} // namespace kanexpr
