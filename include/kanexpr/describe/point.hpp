#pragma once

#include <kanexpr/describe/frame.hpp>

namespace kanexpr {

namespace describe {

template <class Point>
constexpr point_record record_point() {
  point_record r;
  if constexpr (requires { Point::place(); }) {
    r = Point::place();
  } else { // not a point
    r.unparsed = is_unparsed<Point>();
    if constexpr (requires { Point::content(); }) {
      const body_record body = Point::content();
      r.instead = body.beam != nullptr ? a_beam : "a body";
      if (body.beam == nullptr) r.its_own = body.center->called;
    } else if constexpr (requires { Point::orientation(); }) {
      r.instead = "a frame";
    }
  }
  r.called = type_name<Point>();
  if constexpr (requires { sizeof(Point); })
    r.conflict = find_base_conflict<Point>(); // not possible for an incomplete type
  if constexpr (requires { Point::both_fixed_in; }) r.fixed_in = Point::both_fixed_in;
  if constexpr (requires { Point::moves_in; }) {
    r.reference = Point::moves_in;
    r.velocity = Point::declared_velocity;
    r.moves_apart = Point::moves_apart;
    if (r.fits) r.fits = Point::moves_with;
  }
  return r;
}

template <class Point>
inline constexpr point_record point_of = record_point<Point>();

} // namespace describe

/// A point fixed in the inertial frame: `struct O : origin<O, N> {};`
template <class Self, class... Frame>
struct origin : describe::place_words {
  static constexpr describe::point_record place() {
    const describe::frame_record* const frames[]{&describe::frame_of<Frame>..., nullptr};
    describe::point_record r;
    r.declared_name = type_name<Self>();
    r.fits = describe::arguments_of("origin<Self, Frame>", sizeof...(Frame), 1);
    r.origin_of = frames[0];
    return r;
  }
};

/// A point given by its position vector from another point: `struct P : offset<P, O, l*A::x> {};` Its
/// velocity follows from the rate of the vector unless `fixed_in` or `velocity` declares it.
template <class Self, class From, auto... vector>
struct offset : describe::place_words {
  static constexpr describe::point_record place() {
    describe::point_record r;
    r.declared_name = type_name<Self>();
    r.parent = &describe::point_of<From>;
    r.fits = describe::arguments_of("offset<Self, From, vector>", sizeof...(vector), 1);
    r.offset = describe::given_phrases<vector...>[0];
    return r;
  }
};

/// Declares that this point and the one from which it is offset are fixed in `Frame`: v = v_from + ω × r
/// (two-point theorem).
template <class Frame>
struct fixed_in : describe::fixing_words {
  static constexpr const describe::frame_record* both_fixed_in = &describe::frame_of<Frame>;
};

namespace describe {

template <text form, bool is_independent, class Reference, auto... value>
struct declared_motion : velocity_words {
  static constexpr const frame_record* moves_in = &frame_of<Reference>;
  static constexpr phrase declared_velocity = given_phrases<value...>[0];
  static constexpr arguments moves_with = arguments_of(form.view(), sizeof...(value), 1);
  static constexpr bool moves_apart = is_independent;
};

} // namespace describe

/// Declares a point's velocity in `Reference`. In the inertial frame this is the whole velocity; in any other
/// frame, the point from which it is offset must be fixed in that frame: v = v_from + ω × r + value
/// (one-point theorem). The velocity must be the rate of the point's position, unless the offset is zero,
/// which means that the model omits the position.
template <class Reference, auto... value>
struct velocity : describe::declared_motion<"velocity<Reference, vector>", false, Reference, value...> {};

/// Declares the velocity of a point whose position is intentionally inconsistent with it.
template <class Reference, auto... value>
struct velocity_apart_from_position
    : describe::declared_motion<"velocity_apart_from_position<Reference, vector>", true, Reference,
                                value...> {};

} // namespace kanexpr
