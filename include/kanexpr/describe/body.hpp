#pragma once

#include <kanexpr/describe/point.hpp>

namespace kanexpr {

namespace describe {

/// Records the argument passed as an inertia, even if it is not one.
template <class Inertia>
constexpr void give_inertia(body_record& r) {
  if constexpr (requires { Inertia::give_to(r); })
    Inertia::give_to(r);
  else
    r.instead_of_inertia = type_name<Inertia>();
}

/// An inertia with an unusual property that is intentional; `mark` is the member of the record that states
/// it.
template <text form, bool body_record::* mark, class... Inertia>
struct marked_inertia : inertia_words {
  static constexpr void give_to(body_record& r) {
    if (r.fits) r.fits = arguments_of(form.view(), sizeof...(Inertia), 1);
    (give_inertia<Inertia>(r), ...);
    r.*mark = true;
  }
};

} // namespace describe

/// Inertia about the mass center, specified by its entries in the axes of `Frame`: I = Σ m (r·r E − r r).
///
/// Ixx, Iyy, Izz, followed by Ixy, Iyz, Izx if they are not zero.
template <class Frame, auto... scalars>
struct inertia : describe::inertia_words {
  static constexpr void give_to(describe::body_record& r) {
    r.inertia_axes = &describe::frame_of<Frame>;
    if (r.fits)
      r.fits =
          describe::arguments_of("inertia<Frame, Ixx, Iyy, Izz, Ixy, Iyz, Izx>", sizeof...(scalars), 3, 6);
    r.has_whole_zeros = (describe::is_whole_zero(scalars) && ...);
    for (int i = 0; i < 6; ++i) r.inertia[i] = describe::given_phrases_with_zeros<scalars...>[i];
  }
};

/// Inertia about the mass center as a sum of dyadics, in any frames: `inertia_dyadic<I*outer(A::x, A::x) +
/// …>`.
template <auto... value>
struct inertia_dyadic : describe::inertia_words {
  static constexpr void give_to(describe::body_record& r) {
    if (r.fits) r.fits = describe::arguments_of("inertia_dyadic<dyadic>", sizeof...(value), 1);
    r.inertia_dyadic = describe::given_phrases<value...>[0];
  }
};

/// An inertia given about a point other than the mass center.
template <class Point, class... Inertia>
struct inertia_about : describe::inertia_words {
  static constexpr void give_to(describe::body_record& r) {
    if (r.fits) r.fits = describe::arguments_of("inertia_about<Point, Inertia>", sizeof...(Inertia), 1);
    (describe::give_inertia<Inertia>(r), ...);
    r.about = &describe::point_of<Point>;
  }
};

/// An inertia that intentionally varies relative to the body, because it is given in axes that rotate
/// relative to the body or about a point that moves relative to it.
template <class... Inertia>
struct changing_inertia : describe::marked_inertia<"changing_inertia<Inertia>",
                                                   &describe::body_record::inertia_changes, Inertia...> {};

/// An inertia that intentionally does not correspond to any mass distribution, because it was identified from
/// measured motions or is increased about one axis by a gear: `effective_inertia<inertia<A, 0.1, 0.1,
/// 0.35>>`.
template <class... Inertia>
struct effective_inertia
    : describe::marked_inertia<"effective_inertia<Inertia>", &describe::body_record::effective, Inertia...> {
};

/// A mass at a point: `struct Bob : particle<Bob, P, m> {};`
template <class Self, class Point, auto... mass>
struct particle : describe::body_words {
  static constexpr describe::body_record content() {
    describe::body_record r;
    r.called = type_name<Self>();
    r.declared_name = r.called;
    r.fits = describe::arguments_of("particle<Self, Point, mass>", sizeof...(mass), 1);
    r.center = &describe::point_of<Point>;
    r.mass = describe::given_phrases<mass...>[0];
    return r;
  }
};

/// A rigid body, defined by its mass center, the frame fixed in it, its mass and its inertia.
template <class Self, class Center, class Frame, auto mass, class... Inertia>
struct rigid_body : describe::body_words {
  static constexpr describe::body_record content() {
    describe::body_record r;
    r.called = type_name<Self>();
    r.declared_name = r.called;
    r.rigid = true;
    r.center = &describe::point_of<Center>;
    r.frame = &describe::frame_of<Frame>;
    r.mass = describe::phrase_of<mass>;
    r.fits = describe::arguments_of("rigid_body<Self, Center, Frame, mass, Inertia>", sizeof...(Inertia), 1);
    (describe::give_inertia<Inertia>(r), ...);
    return r;
  }
};

namespace describe {

template <class Body>
inline constexpr body_record body_of = [] {
  body_record r;
  if constexpr (requires { Body::content(); }) {
    r = Body::content();
  } else { // not a body
    r.instead = describe_kind<Body>();
    r.unparsed = is_unparsed<Body>();
  }
  r.called = type_name<Body>();
  if constexpr (requires { sizeof(Body); })
    r.conflict = find_base_conflict<Body>(); // not possible for an incomplete type
  return r;
}();

} // namespace describe

} // namespace kanexpr
