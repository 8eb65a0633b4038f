#pragma once

#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/point.hpp>

#include <cstddef>
#include <string_view>

/// Pathways: lines whose length depends on the configuration, along which loads act.
namespace kanexpr {

/// The sense in which a pathway turns about the axis of the surface around which it is wrapped, on its way
/// from its first point to its last.
enum class wrapping : unsigned char { counterclockwise, clockwise };

namespace describe {

enum class path_word : unsigned char { through_points, given_length, cylinder, sphere, cone, none };

/// A pathway as a model describes it.
struct path_record {
  path_word what = path_word::none;
  arguments fits{};
  listing<point_record> points{};
  phrase length{};
  const frame_record* frame = nullptr; ///< in which the surface is fixed
  const point_record* center = nullptr;
  phrase axis{};
  phrase size{};
  wrapping sense{};
  bool first_is_on_surface = false, last_is_on_surface = false;
  std::string_view called{};  ///< the type in place of a pathway
  std::string_view instead{}; ///< the actual kind, if it is not a pathway

  constexpr bool ends_at_points() const { return points.size != 0; }
};

/// The points of a pathway through points; `form` is the form that error messages suggest.
template <std::size_t least, std::size_t most, class... Points>
constexpr path_record path_through(std::string_view form) {
  path_record r;
  r.what = path_word::through_points;
  r.fits = arguments_of(form, sizeof...(Points), least, most);
  r.points = list_of<point_record, &point_of<Points>...>::all;
  return r;
}

} // namespace describe

/// An end of a pathway that lies on the surface around which the pathway is wrapped: `on_surface<P>`.
template <class Point>
struct on_surface {};

namespace describe {

template <class End>
struct end_of_path {
  using point = End;
  static constexpr bool is_on_surface = false;
};
template <class Point>
struct end_of_path<on_surface<Point>> {
  using point = Point;
  static constexpr bool is_on_surface = true;
};

template <class First, class Last, class Center>
constexpr path_record path_around(path_word what) {
  path_record r;
  r.what = what;
  r.points = list_of<point_record, &point_of<typename end_of_path<First>::point>,
                     &point_of<typename end_of_path<Last>::point>>::all;
  r.first_is_on_surface = end_of_path<First>::is_on_surface;
  r.last_is_on_surface = end_of_path<Last>::is_on_surface;
  r.center = &point_of<Center>;
  return r;
}

template <class First, class Last, class Frame, class Point, auto axis, auto size>
constexpr path_record path_around_axis(path_word what, wrapping sense) {
  path_record r = path_around<First, Last, Point>(what);
  r.frame = &frame_of<Frame>;
  r.axis = phrase_of<axis>;
  r.size = phrase_of<size>;
  r.sense = sense;
  return r;
}

} // namespace describe

/// The straight line between two points: `straight<P, Q>`.
template <class... Points>
struct straight {
  static constexpr describe::path_record path =
      describe::path_through<2, 2, Points...>("straight<Point, Other>");
};

/// Straight lines from point to point: `through<P, A, B, Q>`. The points between the ends are where a cable
/// slides without friction through an eye or over a small pulley.
template <class... Points>
struct through {
  static constexpr describe::path_record path =
      describe::path_through<3, 256, Points...>("through<Point, Via, ..., Other>");
};

/// A pathway of which only the length is given, as a function of coordinates: `given_length<r1*q1 + r2*q2>`
/// for a tendon with the moment arms r1 and r2. Of an angle, the tension is a torque.
template <auto... length>
struct given_length {
  static constexpr describe::path_record path = [] {
    describe::path_record r;
    r.what = describe::path_word::given_length;
    r.fits = describe::arguments_of("given_length<scalar>", sizeof...(length), 1);
    r.length = describe::given_phrases<length...>[0];
    return r;
  }();
};

/// The shortest line around a cylinder: `around_cylinder<Drum, C, Drum::z, r, P, Q,
/// wrapping::counterclockwise>`. The axis passes through the point `Center` and is fixed in `Frame`. The
/// line consists of a helix and of straight lines that are tangent to the cylinder. If the straight line
/// between the ends does not touch the cylinder, the pathway is straight. It turns less than once about the
/// axis.
template <class Frame, class Center, auto axis, auto radius, class First, class Last, wrapping sense>
struct around_cylinder {
  static constexpr describe::path_record path =
      describe::path_around_axis<First, Last, Frame, Center, axis, radius>(describe::path_word::cylinder,
                                                                           sense);
};

/// The shortest line around a sphere, in the plane of its ends and its center: `around_sphere<C, r, P, Q>`.
template <class Center, auto radius, class First, class Last>
struct around_sphere {
  static constexpr describe::path_record path = [] {
    describe::path_record r = describe::path_around<First, Last, Center>(describe::path_word::sphere);
    r.size = describe::phrase_of<radius>;
    return r;
  }();
};

/// The shortest line around a cone: `around_cone<A, Tip, A::z, angle, P, Q, wrapping::clockwise>`. The axis
/// points from the tip into the cone; `angle` is the angle between the axis and the surface. A line that
/// would slip over the tip has the length NaN.
template <class Frame, class Tip, auto axis, auto angle, class First, class Last, wrapping sense>
struct around_cone {
  static constexpr describe::path_record path =
      describe::path_around_axis<First, Last, Frame, Tip, axis, angle>(describe::path_word::cone, sense);
};

namespace describe {

/// A joint with one coordinate is a pathway whose length is this coordinate.
template <class Joint>
concept joint_as_path = requires {
  Joint::template q<0>;
  Joint::joint_description();
};

template <class Path>
constexpr path_record record_path() {
  path_record r;
  if constexpr (requires { Path::path.what; }) {
    r = Path::path;
  } else if constexpr (joint_as_path<Path>) {
    if constexpr (Path::coordinates_count == 1) {
      r.what = path_word::given_length;
      r.length = phrase_of<Path::template q<0>, Path>;
    } else {
      r.instead = "a joint with more than one coordinate or none";
    }
  } else {
    r.instead = describe_kind<Path>();
  }
  r.called = type_name<Path>();
  return r;
}

template <class Path>
constexpr bool is_path_of_one_file() {
  const path_record r = record_path<Path>();
  return is_of_one_file_only(r.length) || is_of_one_file_only(r.axis) || is_of_one_file_only(r.size);
}

template <class Path, class Where = typename known_in<is_path_of_one_file<Path>()>::type>
inline constexpr path_record path_of = record_path<Path>();

} // namespace describe

} // namespace kanexpr
