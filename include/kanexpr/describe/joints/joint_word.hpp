#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/body.hpp>
#include <kanexpr/describe/letters_of_name.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/describe/symbol.hpp>

#include <cstddef>
#include <string_view>
#include <utility>

/// The words of a joint, which follow its parent as template arguments in any order, and the names that a
/// joint forms from the name of its type.
namespace kanexpr {

namespace describe {

/// Visits the letters of a type's name that are allowed in a symbol's name.
template <class Type, class Visit>
constexpr void each_letter_of_name(Visit visit) {
  each_letter_of_name(type_name<Type>(), visit);
}

template <class Type>
inline constexpr std::size_t name_size = [] {
  std::size_t size = 0;
  each_letter_of_name<Type>([&](char) { ++size; });
  return size;
}();

/// The name of a joint with a prefix or a suffix: `joint_name<"q", Link2>` is q_Link2, and
/// `joint_name<"", Link2, "home">` is Link2_home.
template <text prefix, class Type, text suffix = "">
inline constexpr auto joint_name = [] {
  text<prefix.view().size() + name_size<Type> + suffix.view().size() + 2> all;
  char* to = all.letters;
  for (const char c : prefix.view()) *to++ = c;
  if (!prefix.view().empty()) *to++ = '_';
  each_letter_of_name<Type>([&](char c) { *to++ = c; });
  if (!suffix.view().empty()) *to++ = '_';
  for (const char c : suffix.view()) *to++ = c;
  return all;
}();

/// A special word belongs to particular kinds of joints, whose member type `special` equals that of the word.
/// `twice` and `misplaced` are the mistakes if the word is repeated or used in a different joint.
enum class joint_word : unsigned char { at, home, axis, by, body, stops, rotor, special };

/// Returns the expression with `own` replaced by the axes of a frame.
template <class Expression>
constexpr auto by_axes_of(const frame_record* frame, const Expression& given) {
  if constexpr (requires { given.tokens; }) {
    Expression e = given;
    for (token& t : e.tokens)
      if (t.what == token_kind::basis && t.frame == nullptr) t.frame = frame;
    return e;
  } else {
    return given;
  }
}

/// Whether an expression contains `own` axes.
template <class Expression>
constexpr bool holds_own(const Expression& given) {
  if constexpr (requires { given.tokens; })
    for (const token& t : given.tokens)
      if (t.what == token_kind::basis && t.frame == nullptr) return true;
  return false;
}

/// Whether an expression is a basis vector of a frame or of `own`.
template <class Expression>
constexpr bool is_basis_of(const frame_record* frame, const Expression& given) {
  if constexpr (requires { given.tokens; })
    return sizeof(given.tokens) == sizeof(token) && given.tokens[0].what == token_kind::basis &&
           (given.tokens[0].frame == nullptr || given.tokens[0].frame == frame);
  else
    return false;
}

/// The unit vector along a direction; a basis vector is returned unchanged.
template <class Direction>
constexpr auto unit_along(const Direction& given) {
  if constexpr (requires { requires shape_of_operand<Direction> == shape::vector; }) {
    if constexpr (sizeof(given.tokens) != sizeof(token))
      return normalized(given);
    else
      return given;
  } else {
    return given;
  }
}

template <class Word>
concept word_of_a_joint = requires { Word::joint_word; };

template <class Word, joint_word wanted>
concept is_joint_word = requires { requires Word::joint_word == wanted; };

/// The word of the kind `wanted` among the words of a joint, or `void`.
template <joint_word wanted, class... Words>
struct joint_word_among {
  using type = void;
};
template <joint_word wanted, class Word, class... Words>
struct joint_word_among<wanted, Word, Words...> : joint_word_among<wanted, Words...> {};
template <joint_word wanted, class Word, class... Words>
  requires is_joint_word<Word, wanted>
struct joint_word_among<wanted, Word, Words...> {
  using type = Word;
};

} // namespace describe

/// The location of a joint: in the parent, as a vector from the parent's point, and in the child, as a vector
/// from the child's point in `own` axes. An omitted vector is zero.
template <auto... in_parent_and_child>
struct at {
  static constexpr describe::joint_word joint_word = describe::joint_word::at;
  static constexpr std::size_t count = sizeof...(in_parent_and_child);
  static constexpr auto in_parent = describe::one_of<0, in_parent_and_child..., 0>();
  static constexpr auto in_child = describe::one_of<1, in_parent_and_child..., 0, 0>();
};

/// The axis of a joint, or its two axes: vectors of any length, fixed in the parent or given in `own` axes,
/// the axes of the child.
template <auto... vectors>
struct axis {
  static constexpr describe::joint_word joint_word = describe::joint_word::axis;
  static constexpr std::size_t count = sizeof...(vectors);
  static constexpr auto first = describe::one_of<0, vectors..., own::z>();
  static constexpr auto second = describe::one_of<1, vectors..., own::z, own::z>();
};

/// The rotation of the child from the parent when all coordinates of the joint are zero: an angle and an axis
/// in the parent, or nine direction cosines in the order of `direction_cosines`.
template <auto... given>
struct home {
  static constexpr describe::joint_word joint_word = describe::joint_word::home;
  static constexpr std::size_t count = sizeof...(given);
  static constexpr bool fits = count == 2 || count == 9;
  static constexpr bool is_in_own_axes = (describe::holds_own(given) || ...);
  static constexpr void turn(describe::frame_record& r) {
    r.orientation =
        count == 2 ? describe::orientation_word::rotated : describe::orientation_word::direction_cosines;
    if constexpr (count == 2)
      r.given[0] = describe::given_phrases<given...>[0];
    else
      for (std::size_t i = 0; i < 9; ++i) r.given[i] = describe::given_phrases_with_zeros<given...>[i];
    r.axis = describe::given_phrases<given...>[1];
    r.given_as = count == 2 ? "the angle of frame " : "a direction cosine of frame ";
  }
};

/// The same rotation specified by three successive rotations about the child's own axes: `home_angles<"zyx",
/// a, b, c>`.
template <text sequence, auto... angles>
struct home_angles {
  static constexpr describe::joint_word joint_word = describe::joint_word::home;
  static constexpr bool fits = sizeof...(angles) == 3;
  static constexpr void turn(describe::frame_record& r) {
    r.orientation = describe::orientation_word::body_fixed;
    describe::set_sequence(r, sequence.view());
    for (std::size_t i = 0; i < 3; ++i) r.given[i] = describe::given_phrases<angles...>[i];
  }
};

/// The symbols of a joint, chosen by the user: its coordinates, followed by its speeds.
template <auto... symbols>
struct by {
  static constexpr describe::joint_word joint_word = describe::joint_word::by;
  static constexpr std::size_t count = sizeof...(symbols);
  template <std::size_t index>
  static constexpr auto symbol = describe::one_of<index, symbols...>();
};

/// The body that moves with the child: its mass, its mass center as a vector from the child's point, and its
/// inertia about the mass center. Without an inertia, the body is a particle; the default mass center is the
/// child's point. `own` denotes the axes of the child, including in `inertia<own, Ixx, …>`.
template <auto mass, auto center = 0.0 * own::x, class... Inertia>
struct body {
  static constexpr describe::joint_word joint_word = describe::joint_word::body;
  static constexpr bool fits = sizeof...(Inertia) <= 1;
  static constexpr auto center_given = center;
  static constexpr void give_to(describe::body_record& r) {
    r.mass = describe::phrase_of<mass>;
    r.rigid = sizeof...(Inertia) == 1;
    (describe::give_inertia<Inertia>(r), ...);
  }
};

/// Combines a frame and a point into the parent of a joint, as in `pin<Link, frame_and_point<A, P>, …>`.
template <class Frame, class Point>
struct frame_and_point {};

namespace describe {

template <class Parent>
struct parts_of {
  static constexpr const frame_record* frame() { return &frame_of<Parent>; }
  static constexpr const point_record* point() { return &point_of<Parent>; }
};
template <class Frame, class Point>
struct parts_of<frame_and_point<Frame, Point>> {
  static constexpr const frame_record* frame() { return &frame_of<Frame>; }
  static constexpr const point_record* point() { return &point_of<Point>; }
};

} // namespace describe

} // namespace kanexpr
