#pragma once

#include <kanexpr/describe/joints/joint_word.hpp>

#include <string_view>

/// The mistakes in the words of a joint. Each is the end of a sentence whose subject is the joint, such as
/// "has two homes"; empty if there is no mistake.
namespace kanexpr::describe {

/// Whether an expression is known not to be a vector.
template <class Expression>
constexpr bool is_no_vector() {
  if constexpr (requires { shape_of_operand<Expression>; })
    return shape_of_operand<Expression> != shape::vector;
  else
    return plain_number<Expression>; // all other types are checked when they are read
}

/// Whether an expression contains axes of frames other than `frame` (null for `own` axes only), or positions,
/// which may be expressed in any axes.
template <class Expression>
constexpr bool holds_other_axes(const Expression& given, const frame_record* frame = nullptr) {
  if constexpr (requires { given.tokens; })
    for (const token& t : given.tokens)
      if (t.what == token_kind::position || (t.what == token_kind::basis && t.frame != frame)) return true;
  return false;
}

template <class Word>
constexpr bool is_parent() {
  if constexpr (!word_of_a_joint<Word> && requires { sizeof(Word); })
    return __is_base_of(orientation_words, Word) || __is_base_of(place_words, Word);
  else
    return false;
}

template <class Joint, joint_word wanted>
constexpr std::size_t count_of() {
  if constexpr (requires { Joint::template word<wanted>::count; })
    return Joint::template word<wanted>::count;
  else
    return 0;
}

template <class Joint>
constexpr std::string_view mistake_of_place() {
  if constexpr (Joint::template has<joint_word::at>) {
    using given = typename Joint::template word<joint_word::at>;
    if (Joint::template times<joint_word::at> > 1)
      return "has two positions; write at<vector in the parent, vector in its own axes>";
    if (given::count == 0 || given::count > 2)
      return "has at<...> with no vector or more than two; write at<vector in the parent, vector in its own "
             "axes>";
    if (is_no_vector<std::remove_cv_t<decltype(given::in_parent)>>() ||
        (given::count == 2 && is_no_vector<std::remove_cv_t<decltype(given::in_child)>>()))
      return "has a position that is not a vector; write at<vector in the parent, vector in its own axes>";
    if (holds_own(given::in_parent))
      return "has a position in the parent given in own axes; write at<vector in axes of the parent, vector "
             "in its own axes>";
    if (holds_other_axes(given::in_child))
      return "has a position in the child given in the axes of a different frame; write at<vector in the "
             "parent, vector in its own axes>";
  }
  return {};
}

template <class Joint>
constexpr std::string_view mistake_of_home() {
  if constexpr (Joint::template has<joint_word::home>) {
    using given = typename Joint::template word<joint_word::home>;
    if (Joint::template times<joint_word::home> > 1) return "has two homes";
    if constexpr (requires { given::is_in_own_axes; })
      if (given::is_in_own_axes)
        return "has a home given in own axes, which turn with it; write home<angle, axis of the parent>";
    if (!given::fits)
      return "has a home that is neither an angle and an axis, nor nine direction cosines, nor three angles";
  }
  return {};
}

template <class Joint>
constexpr std::string_view mistake_of_body() {
  if constexpr (Joint::template has<joint_word::body>) {
    using given = typename Joint::template word<joint_word::body>;
    if (Joint::template times<joint_word::body> > 1)
      return "has two bodies; attach the second one with weld<...>";
    if (!given::fits) return "has a body with two inertias";
    if (is_no_vector<std::remove_cv_t<decltype(given::center_given)>>())
      return "has a mass center that is not a vector; write body<mass, vector in its own axes, inertia>";
    if (holds_other_axes(given::center_given))
      return "has a mass center given in the axes of a different frame; write body<mass, vector in its "
             "own axes, inertia>";
  }
  return {};
}

/// The words that only a joint with one coordinate takes.
template <class Joint>
constexpr std::string_view mistake_of_drive() {
  if (Joint::template times<joint_word::stops> > 1) return "has stops<...> twice; write one list";
  if (Joint::template times<joint_word::rotor> > 1) return "has two rotors";
  if constexpr (Joint::template has<joint_word::stops>)
    if (const std::size_t given = Joint::template word<joint_word::stops>::count; given < 4 || given > 5)
      return "has stops<...> with too few or too many values; write stops<least, greatest, stiffness, "
             "damping, width>";
  if constexpr (Joint::template has<joint_word::rotor>)
    if (const std::size_t given = Joint::template word<joint_word::rotor>::count; given == 0 || given > 2)
      return "has rotor<...> with no inertia or too many values; write rotor<inertia, gear ratio>";
  if (Joint::coordinates_count == 1) return {};
  if (Joint::template has<joint_word::stops>) return "has stops, but not exactly one coordinate";
  if (Joint::template has<joint_word::rotor>) return "has a rotor, but not exactly one coordinate";
  return {};
}

/// Checks the words that all joints take, and the special ones.
template <class Joint, class... Words>
constexpr std::string_view mistake_of_words() {
  if ((is_parent<Words>() || ...))
    return "has a second parent; a joint has one, and a loop is closed by a constraint such as "
           "coincident<...>";
  if (!(word_of_a_joint<Words> && ...))
    return "has an argument that is not a word of a joint; the words are at<...>, axis<...>, home<...>, "
           "by<...>, body<...>, stops<...> and rotor<...>";
  if (Joint::template times<joint_word::axis> > 1) return "has axis<...> twice; write one list";
  if constexpr (Joint::template has<joint_word::special>) {
    using given = typename Joint::template word<joint_word::special>;
    if (!requires { requires std::same_as<typename Joint::kind::special, typename given::special>; })
      return given::misplaced;
    if (Joint::template times<joint_word::special> > 1) return given::twice;
  }
  if (Joint::template times<joint_word::by> > 1) return "has by<...> twice; write one list";
  for (std::string_view mistake : {mistake_of_place<Joint>(), mistake_of_home<Joint>(),
                                   mistake_of_body<Joint>(), mistake_of_drive<Joint>()})
    if (!mistake.empty()) return mistake;
  return {};
}

/// Checks the kind and number of axes and symbols; the kind of joint provides the correct form.
template <class Joint>
constexpr std::string_view mistake_of_kind() {
  using kind = typename Joint::kind;
  constexpr std::size_t axes = count_of<Joint, joint_word::axis>();
  if (Joint::template has<joint_word::by> &&
      count_of<Joint, joint_word::by>() != Joint::coordinates_count + Joint::speeds_count)
    return "has too few or too many symbols";
  if (axes < kind::least_axes) return "lacks an axis";
  if constexpr (requires { kind::without_special; } && !Joint::template has<joint_word::special>)
    return kind::without_special;
  if (axes > kind::most_axes) return "has too many axes";
  if constexpr (axes > 0) {
    using given = typename Joint::template word<joint_word::axis>;
    if (is_no_vector<std::remove_cv_t<decltype(given::first)>>() ||
        is_no_vector<std::remove_cv_t<decltype(given::second)>>())
      return "has an axis that is not a vector";
    if constexpr (requires { kind::is_second_axis_of_child; })
      if (holds_other_axes(given::second))
        return "has a second axis given in the axes of a frame other than its own";
  }
  return {};
}

} // namespace kanexpr::describe
