#pragma once

#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/point.hpp>

namespace kanexpr {

enum class describe::load_word : unsigned char {
  force,
  torque,
  gravity,
  potential_energy,
  spring,
  damper,
  torsional_spring,
  torsional_damper,
  path_force,
  path_spring,
  path_cubic_spring,
  path_damper,
  path_stop,
  bushing,
  friction,
  contact,
  muscle,
  tyre,
  none,
};

/// A force acting at a point: `force<P, F*N::x>`.
template <class Point, auto... vector>
struct force : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::force,
      .word = "the force",
      .fits = describe::arguments_of("force<Point, vector>", sizeof...(vector), 1),
      .point = &describe::point_of<Point>,
      .value = describe::given_phrases<vector...>[0]};
};

namespace describe {

template <class Point, auto... coefficient>
inline constexpr phrase drag_on[]{
    phrase_of<-(whole_argument(coefficient) * magnitude(velocity_of<Point>)) * velocity_of<Point>>...,
    no_phrase};

template <auto... coefficient>
inline constexpr coefficient_record drag_coefficient{
    "the drag coefficient", units::si::kilogram / units::si::meter, given_phrases<coefficient...>[0]};

} // namespace describe

/// A force that opposes the velocity of a point and is quadratic in it: `drag<P, c>` is −c |v| v. For a body
/// in a fluid c is ½ ρ C A, where ρ is the density, C the drag coefficient and A the frontal area.
template <class Point, auto... coefficient>
struct drag : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::force,
      .word = "the drag",
      .fits = describe::arguments_of("drag<Point, coefficient>", sizeof...(coefficient), 1),
      .point = &describe::point_of<Point>,
      .value = describe::drag_on<Point, coefficient...>[0],
      .coefficient = &describe::drag_coefficient<coefficient...>};
};

/// A torque acting on everything that is fixed in a frame: `torque<A, T*N::z>`.
template <class Frame, auto... vector>
struct torque : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::torque,
      .word = "the torque",
      .fits = describe::arguments_of("torque<Frame, vector>", sizeof...(vector), 1),
      .frame = &describe::frame_of<Frame>,
      .value = describe::given_phrases<vector...>[0]};
};

/// A force on one point and the opposite force on another: `force_between<P, Q, F*A::x>`.
template <class Point, class Other, auto... vector>
struct force_between : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::force,
      .word = "the force",
      .fits = describe::arguments_of("force_between<Point, Other, vector>", sizeof...(vector), 1),
      .point = &describe::point_of<Point>,
      .other_point = &describe::point_of<Other>,
      .value = describe::given_phrases<vector...>[0]};
};

/// A torque on everything that is fixed in one frame and the opposite torque on another frame, as exerted by
/// a motor between them: `torque_between<B, A, T*A::z>`.
template <class Frame, class Other, auto... vector>
struct torque_between : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::torque,
      .word = "the torque",
      .fits = describe::arguments_of("torque_between<Frame, Other, vector>", sizeof...(vector), 1),
      .frame = &describe::frame_of<Frame>,
      .other_frame = &describe::frame_of<Other>,
      .value = describe::given_phrases<vector...>[0]};
};

/// Uniform gravity on every body, given by the gravitational acceleration: `gravity<-g*N::z>`.
template <auto... acceleration>
struct gravity : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::gravity,
      .word = "gravity",
      .fits = describe::arguments_of("gravity<vector>", sizeof...(acceleration), 1),
      .value = describe::given_phrases<acceleration...>[0]};
};

/// A potential energy as a function of coordinates, parameters, time and inputs:
/// `potential_energy<k*q1*q1/2>`.
template <auto... energy>
struct potential_energy : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::potential_energy,
      .word = "the potential energy",
      .fits = describe::arguments_of("potential_energy<scalar>", sizeof...(energy), 1),
      .value = describe::given_phrases<energy...>[0],
      .known_by = describe::given_phrases<energy...>[0],
      .once = true};
};

/// A straight massless spring that pulls two points together with the force stiffness·(distance − natural
/// length): `spring<P, Q, k, l0>`. If a natural length is specified, the force has no direction at zero
/// distance and is NaN.
template <class Point, class Other, auto... stiffness_and_length>
struct spring : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::spring,
      .word = "the spring",
      .fits = describe::arguments_of("spring<Point, Other, stiffness, natural length>",
                                     sizeof...(stiffness_and_length), 1, 2),
      .point = &describe::point_of<Point>,
      .other_point = &describe::point_of<Other>,
      .value = describe::given_phrases<stiffness_and_length...>[0],
      .rest = describe::given_phrases<stiffness_and_length...>[1]};
};

/// A straight massless damper that pulls two points together with the force damping·(rate of change of their
/// distance): `damper<P, Q, c>`. The force is NaN at zero distance.
template <class Point, class Other, auto... damping>
struct damper : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::damper,
      .word = "the damper",
      .fits = describe::arguments_of("damper<Point, Other, damping>", sizeof...(damping), 1),
      .point = &describe::point_of<Point>,
      .other_point = &describe::point_of<Other>,
      .value = describe::given_phrases<damping...>[0]};
};

/// A spring that returns an angle to its rest value with the torque stiffness·(angle − rest):
/// `torsional_spring<q2, k>`, `torsional_spring<q2 - q1, k, a>`.
template <auto... angle_stiffness_and_rest>
struct torsional_spring : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::torsional_spring,
      .word = "the torsional spring",
      .fits = describe::arguments_of("torsional_spring<angle, stiffness, rest>",
                                     sizeof...(angle_stiffness_and_rest), 2, 3),
      .value = describe::given_phrases<angle_stiffness_and_rest...>[1],
      .angle = describe::given_phrases<angle_stiffness_and_rest...>[0],
      .rest = describe::given_phrases<angle_stiffness_and_rest...>[2],
      .known_by = describe::given_phrases<angle_stiffness_and_rest...>[0],
      .once = true};
};

/// A torque −damping·ω on everything that is fixed in one frame and the opposite torque on another frame,
/// where ω is the angular velocity of the first relative to the second: `torsional_damper<B, A, c>`.
template <class Frame, class Other, auto... damping>
struct torsional_damper : describe::load_words {
  static constexpr describe::load_record load{
      .what = describe::load_word::torsional_damper,
      .word = "the torsional damper",
      .fits = describe::arguments_of("torsional_damper<Frame, Other, damping>", sizeof...(damping), 1),
      .frame = &describe::frame_of<Frame>,
      .other_frame = &describe::frame_of<Other>,
      .value = describe::given_phrases<damping...>[0]};
};

namespace describe {

template <class Load>
constexpr load_record record_load() {
  load_record r;
  if constexpr (requires { Load::load; }) {
    r = Load::load;
  } else {
    r.what = load_word::none;
    r.called = type_name<Load>();
    r.instead = describe_kind<Load>();
    r.unparsed = is_unparsed<Load>();
  }
  if constexpr (requires { sizeof(Load); }) {
    r.conflict = find_base_conflict<Load>();
    if (r.conflict != nullptr) r.called = type_name<Load>();
  }
  return r;
}

template <class Load>
constexpr bool is_load_of_one_file() {
  bool found = false;
  if constexpr (requires { Load::load; }) {
    for (const phrase* each : {&Load::load.value, &Load::load.angle, &Load::load.rest, &Load::load.known_by})
      found = found || is_of_one_file_only(*each);
    for (int i = 0; i < Load::load.terms_given; ++i)
      found = found || is_of_one_file_only(Load::load.terms[i]);
    for (const phrase& each : Load::load.dynamics) found = found || is_of_one_file_only(each);
  }
  return found;
}

template <class Load, class Where = typename known_in<is_load_of_one_file<Load>()>::type>
inline constexpr load_record load_of = record_load<Load>();

} // namespace describe

} // namespace kanexpr
