#pragma once

#include <kanexpr/describe/bristle.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/diagnostics/misplaced_type.hpp>
#include <kanexpr/describe/friction.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/describe/point.hpp>
#include <kanexpr/describe/surface.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <concepts>
#include <string_view>
#include <type_traits>

/// Contacts between bodies.
namespace kanexpr {

namespace describe {

enum class contact_word : unsigned char {
  elastic,
  smoothed_over,
  damping,
  rolling_resistance,
  spinning_resistance,
  directional_friction
};

template <class Word, contact_word wanted>
concept is_contact_word = requires { requires Word::contact_word == wanted; };

template <class Word>
concept word_of_a_contact = law_of_friction<Word> || requires { Word::contact_word; };

template <class Word>
constexpr void add_to_contact(contact_record& r) {
  arguments fits;
  if constexpr (law_of_friction<Word>) {
    r.friction = &friction_of<Word>;
    fits = r.friction->fits;
  } else {
    Word::add_to(r);
    fits = Word::fits;
  }
  if (r.fits) r.fits = fits;
}

/// Whether a value is the integer 1, such as 3/2 in C++.
template <class Written>
constexpr bool is_whole_one(const Written& value) {
  if constexpr (plain_number<Written> && std::integral<Written>)
    return value == Written{1};
  else
    return false;
}

template <contact_word wanted, class... Words>
inline constexpr int times_of_contact_word = (0 + ... + static_cast<int>(is_contact_word<Words, wanted>));

/// Returns the end of a sentence about words that are missing, repeated or foreign; empty if there is none.
template <class... Words>
constexpr std::string_view mistake_of_contact_words() {
  using enum contact_word;
  if constexpr (!(word_of_a_contact<Words> && ...))
    return "has an argument that is neither elastic<...>, smoothed_over<...>, restitution<...>, "
           "dissipation<...>, rolling_resistance<...>, spinning_resistance<...>, directional_friction<...> "
           "nor a law of friction";
  else if (times_of_contact_word<elastic, Words...> != 1)
    return "needs one elastic<stiffness, exponent>";
  else if (times_of_contact_word<smoothed_over, Words...> != 1)
    return "needs one smoothed_over<width>";
  else if (times_of_contact_word<damping, Words...> > 1)
    return "has more than one of restitution<...> and dissipation<...>";
  else if (times_of_contact_word<rolling_resistance, Words...> > 1)
    return "has two rolling_resistance<...>";
  else if (times_of_contact_word<spinning_resistance, Words...> > 1)
    return "has two spinning_resistance<...>";
  else if (times_of_contact_word<directional_friction, Words...> > 1)
    return "has two directional_friction<...>";
  else if ((0 + ... + static_cast<int>(law_of_friction<Words>)) > 1)
    return "has two laws of friction";
  return {};
}

template <class Geometry, class... Words>
constexpr contact_record record_contact() {
  contact_record r;
  if constexpr (requires { Geometry::lay_out(r); })
    Geometry::lay_out(r);
  else
    r.mistake = "begins with neither sphere_on_plane<...>, point_on_plane<...>, torus_on_plane<...>, "
                "sphere_on_sphere<...> nor point_on_surface<...>";
  if (r.mistake.empty()) r.mistake = mistake_of_contact_words<Words...>();
  if constexpr ((word_of_a_contact<Words> && ...)) {
    (add_to_contact<Words>(r), ...);
  }
  return r;
}

template <class Geometry, class... Words>
inline constexpr contact_record contact_of = record_contact<Geometry, Words...>();

/// The frame of a body: the given one, or that of the point itself if it is a joint.
template <class Point, class... Frame>
constexpr const frame_record* frame_of_body() {
  const frame_record* const frames[]{&frame_of<Frame>..., nullptr};
  if constexpr (sizeof...(Frame) == 0)
    return &frame_of<Point>;
  else
    return frames[0];
}

} // namespace describe

/// A sphere above a plane, as the first argument of a contact. The plane contains the point `Place`; its
/// normal points to the side of the sphere, and the plane is fixed in the frame in whose axes the normal is
/// given. `sphere_on_plane<Ball, r, O, N::z>` if Ball is a joint, which is both a point and a frame;
/// `sphere_on_plane<Center, r, O, N::z, B>` for a sphere that is fixed in the frame B.
template <class Point, auto radius, class Place, auto normal, class... Frame>
struct sphere_on_plane {
  static constexpr void lay_out(describe::contact_record& r) {
    r.shapes = mechanics::contact_shapes::sphere_on_plane;
    r.point = &describe::point_of<Point>;
    r.other_point = &describe::point_of<Place>;
    r.frame = describe::frame_of_body<Point, Frame...>();
    r.normal = describe::phrase_of<normal>;
    r.radius = describe::phrase_of<radius>;
    if (sizeof...(Frame) > 1) r.mistake = "has a sphere_on_plane<...> with two frames";
    if constexpr (sizeof...(Frame) == 0 && describe::describe_kind<Point>() == describe::point_out_of_place)
      r.mistake = "has a sphere whose center is a point; write its frame last, as in sphere_on_plane<Center, "
                  "radius, Place, normal, Frame>";
  }
};

/// A point above a plane, as the first argument of a contact: `point_on_plane<P, O, N::z>`.
template <class Point, class Place, auto normal>
struct point_on_plane {
  static constexpr void lay_out(describe::contact_record& r) {
    r.shapes = mechanics::contact_shapes::sphere_on_plane;
    r.point = &describe::point_of<Point>;
    r.other_point = &describe::point_of<Place>;
    r.normal = describe::phrase_of<normal>;
    r.radius = describe::no_phrase;
  }
};

/// A torus above a plane, as the first argument of a contact, such as a wheel with a round rim: its tube has
/// the given radius, and its center line is a circle about the axis. `torus_on_plane<Wheel, axis, radius of
/// the circle, radius of the tube, O, N::z>`; a frame may follow, as for `sphere_on_plane`. The contact is
/// undefined if the axis is parallel to the normal, because a circle then touches the plane.
template <class Point, auto axis, auto circle, auto tube, class Place, auto normal, class... Frame>
struct torus_on_plane {
  static constexpr void lay_out(describe::contact_record& r) {
    r.shapes = mechanics::contact_shapes::torus_on_plane;
    r.point = &describe::point_of<Point>;
    r.other_point = &describe::point_of<Place>;
    r.frame = describe::frame_of_body<Point, Frame...>();
    r.normal = describe::phrase_of<normal>;
    r.axis = describe::phrase_of<axis>;
    r.radius = describe::phrase_of<tube>;
    r.other_radius = describe::phrase_of<circle>;
    if (sizeof...(Frame) > 1) r.mistake = "has a torus_on_plane<...> with two frames";
    if constexpr (sizeof...(Frame) == 0 && describe::describe_kind<Point>() == describe::point_out_of_place)
      r.mistake = "has a torus whose center is a point; write its frame last, as in torus_on_plane<Center, "
                  "axis, radius, tube, Place, normal, Frame>";
  }
};

/// Two spheres outside of each other, as the first argument of a contact: `sphere_on_sphere<A, a, B, b>`; the
/// frames of both may follow. The contact is undefined if the centers coincide.
template <class Point, auto radius, class Other, auto other_radius, class... Frames>
struct sphere_on_sphere {
  static constexpr void lay_out(describe::contact_record& r) {
    r.shapes = mechanics::contact_shapes::sphere_on_sphere;
    r.point = &describe::point_of<Point>;
    r.other_point = &describe::point_of<Other>;
    const describe::frame_record* const frames[]{&describe::frame_of<Frames>..., nullptr};
    if constexpr (sizeof...(Frames) == 0)
      r.frame = &describe::frame_of<Point>, r.other_frame = &describe::frame_of<Other>;
    else if constexpr (sizeof...(Frames) == 2)
      r.frame = frames[0], r.other_frame = frames[1];
    else
      r.mistake = "has a sphere_on_sphere<...> with neither no frame nor two";
    r.radius = describe::phrase_of<radius>;
    r.other_radius = describe::phrase_of<other_radius>;
  }
};

/// A point above a smooth surface, as the first argument of a contact. The surface is where a function of the
/// coordinates vanishes, which are measured from a point in the axes of a frame; the function is positive on
/// the side of the point: `point_on_surface<P, O, N, surface::z - h*sin(k*surface::x)>`. The distance from
/// the surface is taken to the first order, φ/|∇φ|, so it is exact at the surface.
template <class Point, class Place, class Frame, auto level>
struct point_on_surface {
  static constexpr void lay_out(describe::contact_record& r) {
    r.shapes = mechanics::contact_shapes::point_on_surface;
    r.point = &describe::point_of<Point>;
    r.other_point = &describe::point_of<Place>;
    r.other_frame = &describe::frame_of<Frame>;
    r.level = describe::phrase_of<level>;
    r.radius = describe::no_phrase;
  }
};

/// The elastic normal force k δⁿ at the penetration δ, as a word of a contact: `elastic<k, n>`. The exponent
/// n is a number of at least 1, and 1 if it is omitted; 1.5 is that of Hertz. The integer 1 is a mistake,
/// because it is also the value of 3/2 in C++.
template <auto... stiffness_and_exponent>
struct elastic {
  static constexpr auto contact_word = describe::contact_word::elastic;
  static constexpr describe::arguments fits =
      describe::arguments_of("elastic<stiffness, exponent>", sizeof...(stiffness_and_exponent), 1, 2);
  static constexpr void add_to(describe::contact_record& r) {
    r.stiffness = describe::given_phrases<stiffness_and_exponent...>[0];
    r.exponent = sizeof...(stiffness_and_exponent) == 2
                     ? describe::given_phrases<stiffness_and_exponent...>[1]
                     : describe::phrase_of<describe::constant(1)>;
    if constexpr (sizeof...(stiffness_and_exponent) == 2)
      if ([](const auto&, const auto& n) { return describe::is_whole_one(n); }(stiffness_and_exponent...) &&
          r.mistake.empty())
        r.mistake = "has elastic<k, 1>; 1 is also the value of 3/2 in C++; write 1.5, or omit the exponent 1";
  }
};

/// The distance w over which a contact closes, as a word of a contact: the elastic force rises smoothly
/// between the penetrations −w and w, is zero below and k δⁿ above. `smoothed_over<w>`
template <auto... width>
struct smoothed_over {
  static constexpr auto contact_word = describe::contact_word::smoothed_over;
  static constexpr describe::arguments fits =
      describe::arguments_of("smoothed_over<width>", sizeof...(width), 1);
  static constexpr void add_to(describe::contact_record& r) {
    r.width = describe::given_phrases<width...>[0];
  }
};

/// The damping of a contact that gives the coefficient of restitution e, a number in (0, 1], at the approach
/// speed v, as a word of a contact: `restitution<0.7, v>`. A faster impact loses a larger part of its energy.
template <auto e, auto... approach_speed>
struct restitution {
  static constexpr auto contact_word = describe::contact_word::damping;
  static constexpr describe::arguments fits =
      describe::arguments_of("restitution<coefficient, approach speed>", sizeof...(approach_speed), 1);
  static constexpr void add_to(describe::contact_record& r) {
    if constexpr (describe::plain_number<std::remove_const_t<decltype(e)>>)
      r.restitution = static_cast<double>(e);
    else
      r.restitution = -1;
    if (!(r.restitution > 0 && r.restitution <= 1) && r.mistake.empty())
      r.mistake = "has a coefficient of restitution that is not a number in (0, 1]";
    r.approach_speed = describe::given_phrases<approach_speed...>[0];
  }
};

/// The damping c of a contact, in s/m, as a word of a contact: `dissipation<c>`. The normal force is the
/// elastic one times 1 + c δ̇, as by Hunt & Crossley (1975), rounded so that it never pulls.
template <auto... c>
struct dissipation {
  static constexpr auto contact_word = describe::contact_word::damping;
  static constexpr describe::arguments fits = describe::arguments_of("dissipation<c>", sizeof...(c), 1);
  static constexpr void add_to(describe::contact_record& r) { r.damping = describe::given_phrases<c...>[0]; }
};

/// The resistance to rolling, as a word of a contact: a torque −b N ω/√(ω² + ωₛ²) against the part ω of the
/// relative angular velocity that is parallel to the plane of contact. `rolling_resistance<b, ws>`, where b
/// is a length.
template <auto... lever_and_rate>
struct rolling_resistance {
  static constexpr auto contact_word = describe::contact_word::rolling_resistance;
  static constexpr describe::arguments fits =
      describe::arguments_of("rolling_resistance<lever, angular velocity>", sizeof...(lever_and_rate), 2);
  static constexpr void add_to(describe::contact_record& r) {
    r.lever = describe::given_phrases<lever_and_rate...>[0];
    r.rolling_rate = describe::given_phrases<lever_and_rate...>[1];
  }
};

/// The resistance to spinning, as a word of a contact: a torque −b N ω/√(ω² + ωₛ²) against the part ω of the
/// relative angular velocity about the normal. `spinning_resistance<b, ws>`, where b is a length, such as
/// 3π/16 μ a for a contact of spheres with the radius a of the area of contact.
template <auto... lever_and_rate>
struct spinning_resistance {
  static constexpr auto contact_word = describe::contact_word::spinning_resistance;
  static constexpr describe::arguments fits =
      describe::arguments_of("spinning_resistance<lever, angular velocity>", sizeof...(lever_and_rate), 2);
  static constexpr void add_to(describe::contact_record& r) {
    r.spinning_lever = describe::given_phrases<lever_and_rate...>[0];
    r.spinning_rate = describe::given_phrases<lever_and_rate...>[1];
  }
};

/// A direction in which friction differs, as a word of a contact: `directional_friction<Skate::x, 0.05>`. The
/// law of friction holds across the direction, which is a vector fixed in a frame. Along it, the coefficient
/// of friction is multiplied by the ratio, a positive number; in between, the limit of dry friction is an
/// ellipse. The contact is undefined where the direction is parallel to its normal.
template <auto direction, auto... ratio>
struct directional_friction {
  static constexpr auto contact_word = describe::contact_word::directional_friction;
  static constexpr describe::arguments fits =
      describe::arguments_of("directional_friction<vector, ratio>", sizeof...(ratio), 1);
  static constexpr void add_to(describe::contact_record& r) {
    r.direction = describe::phrase_of<direction>;
    r.ratio = describe::given_phrases<ratio...>[0];
  }
};

/// A contact between two bodies, which is open as long as they do not touch: `contact<sphere_on_plane<Ball,
/// r, O, N::z>, elastic<k, 1.5>, smoothed_over<w>, restitution<0.7, v>, coulomb_friction<mu>>`. The normal
/// force is that of Hunt & Crossley, made smooth without a force at a distance, tension or creation of
/// energy.
template <class Geometry, class... Words>
struct contact : describe::load_words {
  static constexpr describe::load_record load = [] {
    const describe::contact_record& c = describe::contact_of<Geometry, Words...>;
    describe::load_record r;
    r.what = describe::load_word::contact;
    r.word = "the contact";
    r.once = true;
    r.fits = c.fits;
    r.point = c.point;
    r.other_point = c.other_point;
    r.contact = &c;
    if constexpr (describe::lays_out_contact<Geometry> && (describe::law_with_bristles<Words> || ...))
      r.states = describe::bristles_on<Geometry>;
    return r;
  }();
};

} // namespace kanexpr
