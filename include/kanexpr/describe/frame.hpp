#pragma once

#include <kanexpr/describe/record.hpp>

namespace kanexpr {

enum class describe::orientation_word : unsigned char {
  inertial,
  rotated,
  body_fixed,
  space_fixed,
  quaternion,
  modified_rodrigues,
  direction_cosines,
};

namespace describe {

template <class Frame>
constexpr frame_record record_frame() {
  frame_record r;
  if constexpr (requires { Frame::orientation(); }) {
    r = Frame::orientation();
  } else { // not a frame
    r.unparsed = is_unparsed<Frame>();
    if constexpr (requires { Frame::content(); }) {
      r.instead = "a body";
      if (Frame::content().frame != nullptr) r.its_own = Frame::content().frame->called;
    } else if constexpr (requires { Frame::place(); }) {
      r.instead = "a point";
    }
  }
  r.called = type_name<Frame>();
  if constexpr (requires { sizeof(Frame); })
    r.beside = find_misfit<Frame>(); // not possible for an incomplete type
  if constexpr (requires { Frame::turns_in; }) {
    r.reference = Frame::turns_in;
    r.angular_velocity = Frame::declared_angular_velocity;
    if (r.fits) r.fits = Frame::turns_with;
    r.turns_apart = Frame::turns_apart;
  }
  return r;
}

template <class Frame>
inline constexpr frame_record frame_of = record_frame<Frame>();

constexpr vector<1> basis(const frame_record* frame, int axis, bool is_of_one_file = false) {
  token t{};
  t.what = token_kind::basis;
  t.index = axis;
  t.frame = frame;
  t.is_of_one_file = is_of_one_file;
  return {{t}};
}

/// Takes the place of the frame if a different frame uses its name.
template <class Other>
inline constexpr frame_record frame_under_another_name = [] {
  frame_record r;
  r.called = r.calls_itself = type_name<Other>();
  r.beside = misfit::name_of_another;
  return r;
}();

/// Gives a frame its basis vectors `Frame::x`, `Frame::y`, `Frame::z`. If `Frame` is a complete type before
/// this base class is, it is not the frame being defined, and the axes would belong to the wrong frame.
template <class Frame, bool is_another = requires { sizeof(Frame); }>
struct axes : orientation_words {
  static constexpr bool are_of_another = is_another;
  static constexpr const frame_record* described =
      is_another ? &frame_under_another_name<Frame> : &frame_of<Frame>;
  static constexpr vector<1> x = basis(described, 0, !is_known_to_all_files<Frame>);
  static constexpr vector<1> y = basis(described, 1, !is_known_to_all_files<Frame>);
  static constexpr vector<1> z = basis(described, 2, !is_known_to_all_files<Frame>);
};

} // namespace describe

/// The axes of the frame that is being described, whose name is not yet available: `struct B : quaternion<B,
/// N, e0, e1, e2, e3>, angular_velocity<N, u1*own::x + u2*own::y + u3*own::z> {};`
struct own {
  static constexpr vector<1> x = describe::basis(nullptr, 0);
  static constexpr vector<1> y = describe::basis(nullptr, 1);
  static constexpr vector<1> z = describe::basis(nullptr, 2);
};

/// The frame in which Newton's laws hold: `struct N : inertial_frame<N> {};`
template <class Self>
struct inertial_frame : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    return r;
  }
};

/// A frame rotated by `angle` (rad, right-handed) about an axis fixed in its parent: `rotated<A, N, q1,
/// N::z>`.
template <class Self, class Parent, auto... angle_and_axis>
struct rotated : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    r.fits = describe::arguments_of("rotated<Self, Parent, angle, axis>", sizeof...(angle_and_axis), 2);
    r.orientation = describe::orientation_word::rotated;
    r.given_as = "the angle of frame ";
    r.parent = &describe::frame_of<Parent>;
    r.given[0] = describe::given_phrases<angle_and_axis...>[0];
    r.axis = describe::given_phrases<angle_and_axis...>[1];
    return r;
  }
};

namespace describe {

template <class Self, class Parent, orientation_word kind, text sequence, auto... angles>
struct sequence_of_turns : axes<Self> {
  static constexpr frame_record orientation() {
    frame_record r;
    r.calls_itself = type_name<Self>();
    r.orientation = kind;
    r.parent = &frame_of<Parent>;
    for (std::size_t i = 0; i < 3 && i < sequence.view().size(); ++i) r.sequence[i] = sequence.letters[i];
    if (sequence.view().size() != 3) r.sequence[0] = '?';
    r.fits = arguments_of(kind == orientation_word::body_fixed
                              ? "body_fixed<Self, Parent, sequence, angle, angle, angle>"
                              : "space_fixed<Self, Parent, sequence, angle, angle, angle>",
                          sizeof...(angles), 3);
    for (int i = 0; i < 3; ++i) r.given[i] = given_phrases<angles...>[i];
    return r;
  }
};

} // namespace describe

/// Three successive rotations about the frame's own axes: `body_fixed<B, N, "zxz", q1, q2, q3>`. All twelve
/// sequences, in letters or digits ("313"). Kane, Likins & Levinson (1983), appendix I.
template <class Self, class Parent, text sequence, auto... angles>
struct body_fixed
    : describe::sequence_of_turns<Self, Parent, describe::orientation_word::body_fixed, sequence, angles...> {
};

/// Three successive rotations about the parent's axes.
template <class Self, class Parent, text sequence, auto... angles>
struct space_fixed : describe::sequence_of_turns<Self, Parent, describe::orientation_word::space_fixed,
                                                 sequence, angles...> {};

/// A frame defined by the unit quaternion e0 + e1 i + e2 j + e3 k of its rotation from the parent.
template <class Self, class Parent, auto... parameters>
struct quaternion : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    r.orientation = describe::orientation_word::quaternion;
    r.given_as = "the quaternion of frame ";
    r.parent = &describe::frame_of<Parent>;
    r.fits = describe::arguments_of("quaternion<Self, Parent, e0, e1, e2, e3>", sizeof...(parameters), 4);
    for (int i = 0; i < 4; ++i) r.given[i] = describe::given_phrases_with_zeros<parameters...>[i];
    return r;
  }
};

/// A frame defined by the modified Rodrigues parameters σ = a tan φ/4 of its rotation from the parent by an
/// angle φ about the unit vector a. They are zero at φ = 0 and infinite after a full turn. Schaub & Junkins,
/// Analytical Mechanics of Space Systems (2018), section 3.6.
template <class Self, class Parent, auto... parameters>
struct modified_rodrigues : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    r.orientation = describe::orientation_word::modified_rodrigues;
    r.given_as = "a modified Rodrigues parameter of frame ";
    r.parent = &describe::frame_of<Parent>;
    r.fits = describe::arguments_of("modified_rodrigues<Self, Parent, s1, s2, s3>", sizeof...(parameters), 3);
    for (int i = 0; i < 3; ++i) r.given[i] = describe::given_phrases<parameters...>[i];
    return r;
  }
};

/// A frame defined by its direction cosine matrix, row by row: v in the parent's axes = matrix · v in the
/// frame's axes. The columns are the frame's basis vectors in the parent's axes.
template <class Self, class Parent, auto... cosines>
struct direction_cosines : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    r.orientation = describe::orientation_word::direction_cosines;
    r.given_as = "a direction cosine of frame ";
    r.parent = &describe::frame_of<Parent>;
    r.fits = describe::arguments_of("direction_cosines<Self, Parent, nine cosines row by row>",
                                    sizeof...(cosines), 9);
    for (int i = 0; i < 9; ++i) r.given[i] = describe::given_phrases_with_zeros<cosines...>[i];
    return r;
  }
};

/// Declares a frame's angular velocity in `Reference`, which always replaces the derived one. It must equal
/// the one that follows from the orientation, except for a spin about an axis whose angle the orientation
/// omits.
template <class Reference, auto... value>
struct angular_velocity : describe::angular_velocity_words {
  static constexpr const describe::frame_record* turns_in = &describe::frame_of<Reference>;
  static constexpr describe::phrase declared_angular_velocity = describe::given_phrases<value...>[0];
  static constexpr describe::arguments turns_with =
      describe::arguments_of("angular_velocity<Reference, vector>", sizeof...(value), 1);
  static constexpr bool turns_apart = false;
};

/// The same for a frame whose orientation intentionally does not follow its angular velocity.
template <class Reference, auto... value>
struct angular_velocity_apart_from_orientation : describe::angular_velocity_words {
  static constexpr const describe::frame_record* turns_in = &describe::frame_of<Reference>;
  static constexpr describe::phrase declared_angular_velocity = describe::given_phrases<value...>[0];
  static constexpr describe::arguments turns_with = describe::arguments_of(
      "angular_velocity_apart_from_orientation<Reference, vector>", sizeof...(value), 1);
  static constexpr bool turns_apart = true;
};

} // namespace kanexpr
