#pragma once

#include <kanexpr/describe/record.hpp>

#include <string_view>

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
      const body_record body = Frame::content();
      r.instead = body.beam != nullptr ? a_beam : "a body";
      if (body.beam == nullptr && body.frame != nullptr) r.its_own = body.frame->called;
    } else if constexpr (requires { Frame::place(); }) {
      r.instead = "a point";
    }
  }
  r.called = type_name<Frame>();
  if constexpr (requires { sizeof(Frame); })
    r.conflict = find_base_conflict<Frame>(); // not possible for an incomplete type
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

/// Replaces the record of a frame whose name is used by a different frame.
template <class Other>
inline constexpr frame_record frame_under_another_name = [] {
  frame_record r;
  r.called = r.declared_name = type_name<Other>();
  r.conflict =
      "a frame other than @ names itself @; the first template argument of a frame's base must be the frame "
      "itself";
  return r;
}();

/// Gives a frame its basis vectors `Frame::x`, `Frame::y`, `Frame::z`. If `Frame` is already a complete type
/// here, it is not the frame being defined, and the axes would belong to the wrong frame.
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

/// The inertial frame, to which Newton's laws apply: `struct N : inertial_frame<N> {};`
template <class Self>
struct inertial_frame : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.declared_name = type_name<Self>();
    return r;
  }
};

namespace describe {

/// Returns the record of a frame that a word orients relative to its parent by the first `count` phrases.
template <class Self, class Parent>
constexpr frame_record oriented(orientation_word word, std::string_view given_as, const arguments& fits,
                                const phrase* given, int count) {
  frame_record r;
  r.declared_name = type_name<Self>();
  r.orientation = word;
  r.given_as = given_as;
  r.fits = fits;
  r.parent = &frame_of<Parent>;
  for (int i = 0; i < count; ++i) r.given[i] = given[i];
  return r;
}

/// Sets a rotation sequence; one that does not have three letters is marked as invalid.
constexpr void set_sequence(frame_record& r, std::string_view sequence) {
  for (std::size_t i = 0; i < 3 && i < sequence.size(); ++i) r.sequence[i] = sequence[i];
  if (sequence.size() != 3) r.sequence[0] = '?';
}

template <class Self, class Parent, orientation_word kind, text sequence, auto... angles>
struct sequence_of_turns : axes<Self> {
  static constexpr frame_record orientation() {
    frame_record r =
        oriented<Self, Parent>(kind, "an angle of frame ",
                               arguments_of(kind == orientation_word::body_fixed
                                                ? "body_fixed<Self, Parent, sequence, angle, angle, angle>"
                                                : "space_fixed<Self, Parent, sequence, angle, angle, angle>",
                                            sizeof...(angles), 3),
                               given_phrases<angles...>, 3);
    set_sequence(r, sequence.view());
    return r;
  }
};

} // namespace describe

/// A frame rotated by `angle` (rad, right-handed) about an axis fixed in its parent: `rotated<A, N, q1,
/// N::z>`.
template <class Self, class Parent, auto... angle_and_axis>
struct rotated : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    constexpr auto& given = describe::given_phrases<angle_and_axis...>;
    describe::frame_record r = describe::oriented<Self, Parent>(
        describe::orientation_word::rotated, "the angle of frame ",
        describe::arguments_of("rotated<Self, Parent, angle, axis>", sizeof...(angle_and_axis), 2), given, 1);
    r.axis = given[1];
    return r;
  }
};

/// Three successive rotations about the frame's own axes: `body_fixed<B, N, "zxz", q1, q2, q3>`. All twelve
/// sequences are supported, in letters or digits ("313"). Kane, Likins & Levinson (1983), appendix I.
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
    return describe::oriented<Self, Parent>(
        describe::orientation_word::quaternion, "the quaternion of frame ",
        describe::arguments_of("quaternion<Self, Parent, e0, e1, e2, e3>", sizeof...(parameters), 4),
        describe::given_phrases_with_zeros<parameters...>, 4);
  }
};

/// A frame defined by the modified Rodrigues parameters σ = a tan φ/4 of its rotation from the parent by an
/// angle φ about the unit vector a. They are zero at φ = 0 and infinite after a full turn. Schaub & Junkins,
/// Analytical Mechanics of Space Systems (2018), section 3.6.
template <class Self, class Parent, auto... parameters>
struct modified_rodrigues : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    return describe::oriented<Self, Parent>(
        describe::orientation_word::modified_rodrigues, "a modified Rodrigues parameter of frame ",
        describe::arguments_of("modified_rodrigues<Self, Parent, s1, s2, s3>", sizeof...(parameters), 3),
        describe::given_phrases<parameters...>, 3);
  }
};

/// A frame defined by its direction cosine matrix, row by row: v in the parent's axes = matrix · v in the
/// frame's axes. The columns are the frame's basis vectors in the parent's axes.
template <class Self, class Parent, auto... cosines>
struct direction_cosines : describe::axes<Self> {
  static constexpr describe::frame_record orientation() {
    return describe::oriented<Self, Parent>(
        describe::orientation_word::direction_cosines, "a direction cosine of frame ",
        describe::arguments_of("direction_cosines<Self, Parent, nine cosines row by row>", sizeof...(cosines),
                               9),
        describe::given_phrases_with_zeros<cosines...>, 9);
  }
};

namespace describe {

template <text form, bool is_independent, class Reference, auto... value>
struct declared_rotation : angular_velocity_words {
  static constexpr const frame_record* turns_in = &frame_of<Reference>;
  static constexpr phrase declared_angular_velocity = given_phrases<value...>[0];
  static constexpr arguments turns_with = arguments_of(form.view(), sizeof...(value), 1);
  static constexpr bool turns_apart = is_independent;
};

} // namespace describe

/// Declares a frame's angular velocity in `Reference`. The declared value always replaces the derived one. It
/// must equal the angular velocity that follows from the orientation, except for a spin about an axis whose
/// angle the orientation omits.
template <class Reference, auto... value>
struct angular_velocity
    : describe::declared_rotation<"angular_velocity<Reference, vector>", false, Reference, value...> {};

/// Declares the angular velocity of a frame whose orientation is intentionally inconsistent with it.
template <class Reference, auto... value>
struct angular_velocity_apart_from_orientation
    : describe::declared_rotation<"angular_velocity_apart_from_orientation<Reference, vector>", true,
                                  Reference, value...> {};

} // namespace kanexpr
