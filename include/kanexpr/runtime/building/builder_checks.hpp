#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/utf8.hpp>
#include <kanexpr/mechanics/checks/check_name.hpp>
#include <kanexpr/mechanics/checks/check_numbers.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <initializer_list>
#include <string_view>

namespace kanexpr::runtime {

using base::sentence;
using mechanics::dyadic;
using mechanics::vector;
using symbolic::expression;

/// The indices of frames and points, as distinct types so that they cannot be confused.
enum class frame_id : int {};
enum class point_id : int {};

constexpr int place(frame_id f) { return static_cast<int>(f); }
constexpr int place(point_id p) { return static_cast<int>(p); }

/// Checks the arguments of a builder and keeps the first mistake.
class builder_checks {
public:
  explicit builder_checks(const mechanics::mechanism& m) : m_(m) {}

  const sentence& mistake() const { return mistake_; }

  bool fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = base::sentence(pieces);
    return false;
  }

  bool fail_integer_zero(std::string_view given) {
    return fail({given, integer_zero, "write 0.5", intended_zero});
  }

  /// Checks that all arguments belong entirely to this mechanism: frames, points, expressions, vectors,
  /// dyadics, sequences and pathways.
  template <class... Arguments>
  bool owns(std::string_view whose, const Arguments&... all) {
    return (owns_one(whose, all) && ...);
  }

  /// Checks the arguments of a load along a pathway. A pathway without points or length is one whose mistake
  /// has been reported.
  bool owns_path_load(std::string_view whose, const mechanics::pathway& along,
                      const base::sequence<expression>& terms) {
    if (mistake_) return false;
    if (along.points.empty() && !along.length.is_given())
      return fail({whose, " acts along a pathway that has no points"});
    return owns(whose, along, terms);
  }

  /// Checks that a name is valid and not used by another entity of its kind.
  template <class Entity>
  bool is_new(std::string_view kinds, std::string_view called, const base::sequence<Entity>& others) {
    if (!is_valid_name(kinds, called)) return false;
    for (const Entity& other : others)
      if (other.called.view() == called) return fail({"two ", kinds, " are called ", called});
    return true;
  }
  bool is_new_symbol(std::string_view called) {
    return is_valid_name("symbols", called) && is_unused(called);
  }
  bool is_new_speed(std::string_view called) {
    return is_new_symbol(called) && is_before_state_variables("a speed is");
  }
  /// Checks that no state variable was declared yet, because these follow all speeds.
  bool is_before_state_variables(std::string_view what) {
    if (m_.state_variables == 0) return true;
    return fail({what, " declared after state variable ", mechanics::called(m_, m_.speeds.back()),
                 "; declare state variables after all speeds"});
  }
  /// Checks that no symbol already has the name.
  bool is_unused(std::string_view called) {
    for (const auto* list : {&m_.coordinates, &m_.speeds, &m_.parameters, &m_.inputs, &m_.auxiliary_speeds})
      for (const expression& e : *list)
        if (mechanics::called(m_, e) == called) return fail({"the name ", called, " is used twice"});
    return called != name_of_time || !has_time_ || fail({"the name ", called, " is used twice"});
  }
  void take_time() {
    if (!has_time_) is_unused(name_of_time);
    has_time_ = true;
  }

private:
  bool owns_one(std::string_view whose, frame_id f) { return exists(whose, "frame", place(f), m_.frames); }
  bool owns_one(std::string_view whose, point_id p) { return exists(whose, "point", place(p), m_.points); }
  bool owns_one(std::string_view whose, expression e) {
    if (!e.belongs_to(*m_.g))
      return fail({whose, " contains an expression that belongs to a different mechanism or to none"});
    if (m_.g->consume_integer_zero())
      return fail({whose, " contains an operation with the integer 0", integer_zero, "write x/2 or 0.5*x",
                   intended_zero});
    if (m_.g->consume_reversed_bounds())
      return fail({whose, " contains clamp with limits out of order; write clamp(x, least, most)"});
    return !numbers_.holds_no_number(e) || fail({whose, " contains a number that is not finite"});
  }
  bool owns_one(std::string_view whose, const mechanics::components& v) { return owns(whose, v.x, v.y, v.z); }
  bool owns_one(std::string_view whose, const mechanics::matrix3& m) {
    return owns(whose, m.row[0], m.row[1], m.row[2]);
  }
  bool owns_one(std::string_view whose, const vector& v) {
    for (const vector::part& p : v.parts)
      if (!owns(whose, frame_id{p.frame}, p.value)) return false;
    return true;
  }
  bool owns_one(std::string_view whose, const dyadic& d) {
    for (const dyadic::part& p : d.parts)
      if (!owns(whose, frame_id{p.left}, frame_id{p.right}, p.value)) return false;
    return true;
  }
  bool owns_one(std::string_view whose, const base::sequence<expression>& scalars) {
    for (const expression& e : scalars)
      if (!owns_one(whose, e)) return false;
    return true;
  }

  /// The pathway may be that of another builder.
  bool owns_one(std::string_view whose, const mechanics::pathway& along) {
    for (const int point : along.points)
      if (!owns_one(whose, point_id{point})) return false;
    if (along.form == mechanics::pathway_form::given_length) return owns_one(whose, along.length);
    if (!along.is_around_surface()) return true;
    return owns(whose, frame_id{along.frame}, point_id{along.center}, along.surface.size, along.surface.axis);
  }

  template <class Entity>
  bool exists(std::string_view whose, std::string_view kind, int number, const base::sequence<Entity>& all) {
    if (number >= 0 && number < all.size()) return true;
    base::name digits;
    digits.append(number);
    return fail({whose, " refers to ", kind, " number ", digits.view(), ", which does not exist"});
  }
  bool is_valid_name(std::string_view kinds, std::string_view called) {
    if (!base::is_utf8(called)) return fail({"the name of one of the ", kinds, " is not valid UTF-8"});
    const sentence found = mechanics::check_name(called, kinds);
    return !found || fail({found.view()});
  }

  static constexpr std::string_view name_of_time = "t";
  static constexpr std::string_view integer_zero = ", which is also the value of 1/2 in C++; ",
                                    intended_zero = ", or 0.0 if you mean zero";

  const mechanics::mechanism& m_;
  mechanics::finiteness numbers_{};
  sentence mistake_{};
  bool has_time_ = false;
};

} // namespace kanexpr::runtime
