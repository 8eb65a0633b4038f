#pragma once

#include <kanexpr/describe/joints/joint_mistakes.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <type_traits>
#include <utility>

/// A joint, represented by its frames, points, symbols and equations. A kind of joint is a struct with these
/// members:
///
///     symbols                joint_symbols<names<"q">, names<"u">>
///     least_axes, most_axes  the least and the greatest number of its axes
///     is_second_axis_of_child   if the second axis is not fixed in the parent
///     form                   the form that error messages suggest
///     special                the type of its special word, if it takes one
///     without_special        the mistake if a required special word is missing
///     moves                  whether its two points can move apart
///     turn<Joint>(frame_record&)   the rotation of the child from its home
///     move<Joint>(point_record&)   the displacement from its base, if it moves
///     spin<Joint>            its angular velocity in the frame from which it is rotated, if it turns
///     drift<Joint>           its velocity in the parent, if it moves
///     bound_spin<Joint>      the part of any angular velocity that it constrains, if not all (freed.hpp)
///     bound_drift<Joint>     the same for any velocity
///     effort                 the effort of a motor, a torque or a force, if it has one axis
///     kinematics<Joint>()    its kinematic equations, if they are not q̇ = u
namespace kanexpr::describe {

/// The effort that can drive a joint with one axis.
enum class joint_effort : unsigned char { none, torque, force };

template <text... all>
struct names {
  static constexpr std::size_t count = sizeof...(all);
};

template <class Coordinates, class Speeds>
struct joint_symbols;

/// The symbols of a joint, chosen by the user or by the library.
template <text... coordinates, text... speeds>
struct joint_symbols<names<coordinates...>, names<speeds...>> {
  static constexpr std::size_t of_position = sizeof...(coordinates), of_motion = sizeof...(speeds);

  template <symbolic::symbol_kind represented, std::size_t index, class Self, text first, text... rest>
  static constexpr auto symbol_called() {
    if constexpr (index == 0)
      return symbol<represented, joint_name<first, Self>, unnumbered>{};
    else
      return symbol_called<represented, index - 1, Self, rest...>();
  }

  template <class Given>
  static constexpr bool has_all = [] {
    if constexpr (requires { Given::count; })
      return Given::count == of_position + of_motion;
    else
      return false;
  }();

  template <std::size_t index, class Self, class Given>
  static constexpr auto position() {
    if constexpr (has_all<Given>)
      return Given::template symbol<index>;
    else
      return symbol_called<symbolic::symbol_kind::coordinate, index, Self, coordinates...>();
  }
  template <std::size_t index, class Self, class Given>
  static constexpr auto motion() {
    if constexpr (has_all<Given>)
      return Given::template symbol<of_position + index>;
    else
      return symbol_called<symbolic::symbol_kind::speed, index, Self, speeds...>();
  }
};

/// Sets a rotation from the home orientation.
constexpr void turn_about(frame_record& r, const phrase& angle, const phrase& axis) {
  r.orientation = orientation_word::rotated;
  r.given_as = "the angle of frame ";
  r.given[0] = angle;
  r.axis = axis;
}

template <class Joint>
constexpr void not_turned(frame_record& r) {
  turn_about(r, no_phrase, phrase_of<basis(Joint::home_frame(), 2), Joint>);
}

template <class Joint, std::size_t index>
inline constexpr auto rate_is_speed = dot(Joint::template q<index>) == Joint::template u<index>;

template <class Joint>
inline constexpr frame_record home_of_joint = Joint::home_record();
template <class Joint>
inline constexpr point_record base_of_joint = Joint::base_record();
template <class Joint>
inline constexpr point_record point_of_joint = Joint::joint_point_record();
template <class Joint>
inline constexpr point_record center_of_joint = Joint::center_record();
template <class Joint>
inline constexpr body_record body_of_joint = Joint::body_record_of_child();
template <class Joint>
constexpr joint_record record_joint();
template <class Joint>
inline constexpr joint_record joint_of = record_joint<Joint>();

/// Whether `Joint` is among the nearest ancestors of a joint, up to `depth`.
template <class Parent, class Joint, int depth>
constexpr bool is_ancestor() {
  if constexpr (std::is_same_v<Parent, Joint>)
    return true;
  else if constexpr (depth > 0 && requires { typename Parent::parent; })
    return is_ancestor<typename Parent::parent, Joint, depth - 1>();
  else
    return false;
}

template <class Self, class Parent, class Kind, class... Words>
struct joint : axes<Self>, place_words, joint_words {
  using kind = Kind;
  template <joint_word wanted>
  using word = typename joint_word_among<wanted, Words...>::type;
  template <joint_word wanted>
  static constexpr bool has = !std::is_void_v<word<wanted>>;
  template <joint_word wanted>
  static constexpr int times = (0 + ... + is_joint_word<Words, wanted>);

  static constexpr std::size_t coordinates_count = Kind::symbols::of_position,
                               speeds_count = Kind::symbols::of_motion;
  template <std::size_t index>
  static constexpr auto q = Kind::symbols::template position<index, Self, word<joint_word::by>>();
  template <std::size_t index>
  static constexpr auto u = Kind::symbols::template motion<index, Self, word<joint_word::by>>();

  using parent = Parent;
  static constexpr bool is_its_own_ancestor = is_ancestor<Parent, Self, 3>();
  static constexpr bool lacks_parent = word_of_a_joint<Parent>;
  /// Whether the joint is well-formed; if not, its record contains a mistake.
  static constexpr bool is_written = !joint::are_of_another && !lacks_parent && !is_its_own_ancestor;
  static constexpr const frame_record* parent_frame() {
    if constexpr (is_its_own_ancestor)
      return nullptr;
    else
      return parts_of<Parent>::frame();
  }
  static constexpr const point_record* parent_point() {
    if constexpr (is_its_own_ancestor)
      return nullptr;
    else
      return parts_of<Parent>::point();
  }
  static constexpr const frame_record* child_frame() { return &frame_of<Self>; }

  /// The child's frame when all coordinates are zero.
  static constexpr const frame_record* home_frame() {
    if constexpr (has<joint_word::home>)
      return &home_of_joint<Self>;
    else
      return parent_frame();
  }

  /// Returns an axis. If it is given in `own` axes, it is fixed both in the home of the child and in the
  /// child; `frame` is the frame that `own` denotes.
  template <std::size_t index>
  static constexpr auto axis_in(const frame_record* frame) {
    if constexpr (!has<joint_word::axis>)
      return by_axes_of(frame, index == 0 ? own::z : own::x);
    else if constexpr (index == 0)
      return unit_along(by_axes_of(frame, word<joint_word::axis>::first));
    else
      return unit_along(by_axes_of(frame, word<joint_word::axis>::second));
  }
  template <std::size_t index>
  static constexpr auto axis_at_home = axis_in<index>(home_frame());
  template <std::size_t index>
  static constexpr auto axis_of_child = axis_in<index>(child_frame());

  static constexpr bool is_off_parent = has<joint_word::at>;
  static constexpr bool is_off_child = count_of<joint, joint_word::at>() > 1;

  /// The location of the joint in the parent.
  static constexpr const point_record* base_point() {
    if constexpr (is_off_parent)
      return &base_of_joint<Self>;
    else
      return parent_point();
  }
  /// The location of the joint in the child.
  static constexpr const point_record* joint_point() {
    if constexpr (is_off_child)
      return &point_of_joint<Self>;
    else
      return &point_of<Self>;
  }

  static constexpr frame_record orientation() {
    frame_record r;
    r.declared_name = type_name<Self>();
    r.is_of_joint = true;
    if constexpr (is_written) {
      r.parent = home_frame();
      Kind::template turn<Self>(r);
    }
    return r;
  }

  static constexpr point_record place() {
    point_record r;
    if constexpr (!is_written) {
      r.origin_of = child_frame();
    } else if constexpr (is_off_child) {
      r.parent = joint_point();
      r.offset = phrase_of<from_joint(child_frame()), Self>;
    } else {
      r = joint_point_record();
    }
    r.declared_name = type_name<Self>();
    r.of_joint = child_frame();
    return r;
  }

  static constexpr frame_record home_record() {
    frame_record r;
    r.called = r.declared_name = joint_name<"", Self, "home">.view();
    r.parent = parent_frame();
    if constexpr (has<joint_word::home>) word<joint_word::home>::turn(r);
    return r;
  }
  static constexpr point_record base_record() {
    point_record r;
    r.called = r.declared_name = joint_name<"", Self, "base">.view();
    r.parent = parent_point();
    if constexpr (is_off_parent) r.offset = phrase_of<word<joint_word::at>::in_parent, Self>;
    return r;
  }
  static constexpr point_record joint_point_record() {
    point_record r = base_record();
    r.called = r.declared_name = joint_name<"", Self, "joint">.view();
    if constexpr (Kind::moves) {
      r.parent = base_point();
      Kind::template move<Self>(r);
    } else if constexpr (!is_off_parent) {
      r.offset = phrase_of<0.0 * basis(parent_frame(), 0), Self>;
    }
    return r;
  }
  static constexpr point_record center_record() {
    point_record r;
    r.called = r.declared_name = joint_name<"", Self, "center">.view();
    r.parent = &point_of<Self>;
    if constexpr (has<joint_word::body>)
      r.offset = phrase_of<by_axes_of(child_frame(), word<joint_word::body>::center_given), Self>;
    return r;
  }
  static constexpr body_record body_record_of_child() {
    body_record r;
    r.called = r.declared_name = type_name<Self>();
    r.center = &center_of_joint<Self>;
    r.frame = child_frame();
    if constexpr (has<joint_word::body>) word<joint_word::body>::give_to(r);
    if (r.inertia_axes == &frame_of<own>) r.inertia_axes = child_frame();
    return r;
  }

  static constexpr joint_record joint_description() {
    joint_record r;
    if constexpr (is_written) {
      r = written();
    } else {
      r.mistake = lacks_parent ? "lacks a parent" : "is attached to itself";
      if (lacks_parent) r.form = Kind::form;
    }
    r.declared_name = type_name<Self>();
    return r;
  }

private:
  static constexpr joint_record written() {
    joint_record r;
    r.frame = child_frame();
    r.point = &point_of<Self>;
    r.home = home_frame();
    r.parent_frame = parent_frame();
    r.parent_point = parent_point();
    list_symbols(r, std::make_index_sequence<coordinates_count>(), std::make_index_sequence<speeds_count>());
    if constexpr (requires { Kind::template kinematics<Self>(); })
      r.kinematics = Kind::template kinematics<Self>();
    else
      r.kinematics = simple_kinematics(std::make_index_sequence<coordinates_count>());
    if constexpr (has<joint_word::body>) r.body = &body_of_joint<Self>;
    if constexpr (has<joint_word::stops>) r.stops = word<joint_word::stops>::template load<Self>();
    if constexpr (has<joint_word::rotor>) {
      r.rotor = word<joint_word::rotor>::given;
      r.has_gear_ratio = word<joint_word::rotor>::count > 1;
    }
    r.mistake = mistake_of_words<joint, Words...>();
    if (!r.mistake.empty()) return r;
    r.axes = axes_to_check();
    if constexpr (is_off_parent)
      if (holds_other_axes(word<joint_word::at>::in_parent, parent_frame()))
        r.place = phrase_of<word<joint_word::at>::in_parent, Self>;
    r.mistake = mistake_of_kind<joint>();
    if (!r.mistake.empty()) r.form = Kind::form;
    return r;
  }

  template <std::size_t... of_position, std::size_t... of_motion>
  static constexpr void list_symbols(joint_record& r, std::index_sequence<of_position...>,
                                     std::index_sequence<of_motion...>) {
    r.coordinates = list_of<phrase, &phrase_of<q<of_position>, Self>...>::all;
    r.speeds = list_of<phrase, &phrase_of<u<of_motion>, Self>...>::all;
  }
  template <std::size_t... index>
  static constexpr listing<phrase> simple_kinematics(std::index_sequence<index...>) {
    return list_of<phrase, &phrase_of<rate_is_speed<Self, index>, Self>...>::all;
  }

  /// The axes to check: each must be fixed and have nonzero length, and two axes must not be parallel.
  static constexpr listing<phrase> axes_to_check() {
    if constexpr (!has<joint_word::axis>) {
      return {};
    } else {
      using given = word<joint_word::axis>;
      if constexpr (given::count == 1 && is_basis_of(parent_frame(), given::first))
        return {};
      else if constexpr (given::count == 1)
        return list_of<phrase, &phrase_of<by_axes_of(home_frame(), given::first), Self>>::all;
      else
        return list_of<phrase, &phrase_of<by_axes_of(home_frame(), given::first), Self>,
                       &phrase_of<by_axes_of(home_frame(), given::second), Self>>::all;
    }
  }

  /// The child's point relative to the location of the joint in the child.
  static constexpr auto from_joint(const frame_record* frame) {
    if constexpr (is_off_child)
      return -by_axes_of(frame, word<joint_word::at>::in_child);
    else
      return 0.0 * basis(frame, 0);
  }
};

/// Returns a mistake in a word, with the name of the joint that contains it.
template <class Joint>
constexpr token misused_with(misuse what) {
  token named = misused(what);
  if constexpr (requires { Joint::child_frame(); }) named.frame = Joint::child_frame();
  return named;
}

template <class Joint>
constexpr joint_effort effort_of_joint() {
  if constexpr (requires { Joint::kind::effort; })
    return Joint::kind::effort;
  else
    return joint_effort::none;
}

template <class Joint>
constexpr joint_record record_joint() {
  joint_record r;
  if constexpr (requires { Joint::joint_description(); }) {
    r = Joint::joint_description();
  } else {
    r.instead = describe_kind<Joint>();
    r.unparsed = is_unparsed<Joint>();
  }
  r.called = type_name<Joint>();
  if constexpr (requires { sizeof(Joint); }) r.conflict = find_base_conflict<Joint>();
  return r;
}

} // namespace kanexpr::describe
