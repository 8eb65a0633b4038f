#pragma once

#include <kanexpr/describe/point.hpp>

namespace kanexpr {

/// Inertia about the mass centre from its scalars in the axes of `Frame`: I = Σ m (r·r E − r r).
template <class Frame, auto ixx, auto iyy, auto izz, auto ixy = 0, auto iyz = 0, auto izx = 0>
struct inertia {
  static constexpr void give_to(describe::body_record& r) {
    using describe::phrase_of;
    r.inertia_axes = &describe::frame_of<Frame>;
    const describe::phrase scalars[]{phrase_of<ixx>, phrase_of<iyy>, phrase_of<izz>,
                                     phrase_of<ixy>, phrase_of<iyz>, phrase_of<izx>};
    for (int i = 0; i < 6; ++i) r.inertia[i] = scalars[i];
  }
};

/// Inertia about the mass centre as a sum of dyadics, in any frames: `inertia_dyadic<I*outer(A::x, A::x) +
/// …>`.
template <auto value>
struct inertia_dyadic {
  static constexpr void give_to(describe::body_record& r) { r.inertia_dyadic = describe::phrase_of<value>; }
};

/// An inertia that is given about another point of the body.
template <class Point, class Inertia>
struct inertia_about {
  static constexpr void give_to(describe::body_record& r) {
    Inertia::give_to(r);
    r.about = &describe::point_of<Point>;
  }
};

/// A mass at a point: `struct Bob : particle<Bob, P, m> {};`
template <class Self, class Point, auto mass>
struct particle {
  static constexpr describe::body_record content() {
    describe::body_record r;
    r.called = type_name<Self>();
    r.calls_itself = r.called;
    r.center = &describe::point_of<Point>;
    r.mass = describe::phrase_of<mass>;
    return r;
  }
};

/// A rigid body by its mass centre, the frame fixed in it, its mass and its inertia.
template <class Self, class Center, class Frame, auto mass, class Inertia>
struct rigid_body {
  static constexpr describe::body_record content() {
    describe::body_record r;
    r.called = type_name<Self>();
    r.calls_itself = r.called;
    r.rigid = true;
    r.center = &describe::point_of<Center>;
    r.frame = &describe::frame_of<Frame>;
    r.mass = describe::phrase_of<mass>;
    Inertia::give_to(r);
    return r;
  }
};

namespace describe {

template <class Body>
inline constexpr body_record body_of = [] {
  body_record r;
  if constexpr (requires { Body::content(); }) r = Body::content(); // else no body: it has no name for itself
  r.called = type_name<Body>();
  return r;
}();

} // namespace describe

} // namespace kanexpr
