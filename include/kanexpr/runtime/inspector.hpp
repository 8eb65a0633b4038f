#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_name.hpp>
#include <kanexpr/mechanics/checks/check_numbers.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
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
class inspector {
public:
  explicit inspector(const mechanics::mechanism& m) : m_(m) {}

  const sentence& mistake() const { return mistake_; }

  bool fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = base::sentence(pieces);
    return false;
  }

  bool present(frame_id f, std::string_view whom) {
    return exists(place(f), m_.frames.size(), "frame", whom);
  }
  bool present(point_id p, std::string_view whom) {
    return exists(place(p), m_.points.size(), "point", whom);
  }

  bool fail_by_whole_zero(std::string_view given) { return fail({given, what_it_is, "write 0.5", for_zero}); }

  /// Checks that an expression belongs entirely to this mechanism.
  bool own(expression e, std::string_view whose) {
    if (!e.belongs_to(*m_.g))
      return fail({whose, " contains an expression that belongs to a different mechanism or to none"});
    if (m_.g->consume_integer_zero())
      return fail(
          {whose, " contains an operation with the integer 0", what_it_is, "write x/2 or 0.5*x", for_zero});
    if (m_.g->consume_reversed_bounds())
      return fail({whose, " contains clamp with limits out of order; write clamp(x, least, most)"});
    return !numbers_.holds_no_number(e) || fail({whose, " contains a number that is not finite"});
  }
  bool own(const mechanics::components& v, std::string_view whose) {
    return own(v.x, whose) && own(v.y, whose) && own(v.z, whose);
  }
  bool own(const mechanics::matrix3& m, std::string_view whose) {
    return own(m.row[0], whose) && own(m.row[1], whose) && own(m.row[2], whose);
  }
  bool own(const vector& v, std::string_view whose) {
    for (const vector::part& p : v.parts)
      if (!present(frame_id{p.frame}, whose) || !own(p.value, whose)) return false;
    return true;
  }
  bool own(const dyadic& d, std::string_view whose) {
    for (const dyadic::part& p : d.parts)
      if (!present(frame_id{p.left}, whose) || !present(frame_id{p.right}, whose) || !own(p.value, whose))
        return false;
    return true;
  }
  bool own(const base::sequence<expression>& scalars, std::string_view whose) {
    for (const expression& e : scalars)
      if (!own(e, whose)) return false;
    return true;
  }

  /// Checks that a name is valid and not used by another entity of its kind.
  template <class Entity>
  bool fresh(std::string_view kinds, std::string_view called, const base::sequence<Entity>& others) {
    if (!tellable(kinds, called)) return false;
    for (const Entity& other : others)
      if (other.called.view() == called) return fail({"two ", kinds, " are called ", called});
    return true;
  }
  bool fresh_symbol(std::string_view called) { return tellable("symbols", called) && unused(called); }
  /// Checks that neither the name nor the name with a prime, which denotes a rate, is used.
  bool unused(std::string_view called) {
    for (const auto* list : {&m_.coordinates, &m_.speeds, &m_.parameters, &m_.inputs, &m_.auxiliary_speeds})
      for (const expression& e : *list)
        if (m_.g->symbol_at(e.node()).called.view() == called)
          return fail({"the name ", called, " is used twice"});
    if (called != name_of_time || !has_time_) return true;
    return fail({"the name ", called, " is used twice"});
  }
  void take_time() {
    if (!has_time_) unused(name_of_time);
    has_time_ = true;
  }

private:
  bool exists(int number, int count, std::string_view what, std::string_view whom) {
    if (number >= 0 && number < count) return true;
    mechanics::name told;
    told.append(number);
    return fail({whom, " refers to ", what, " number ", told.view(), ", which does not exist"});
  }
  bool tellable(std::string_view kinds, std::string_view called) {
    const sentence found = mechanics::check_name(called, kinds);
    return !found || fail({found.view()});
  }

  static constexpr std::string_view name_of_time = "t";
  static constexpr std::string_view what_it_is = ", which is also the value of 1/2 in C++; ",
                                    for_zero = ", or 0.0 if you mean zero";

  const mechanics::mechanism& m_;
  mechanics::finiteness numbers_{};
  sentence mistake_{};
  bool has_time_ = false;
};

} // namespace kanexpr::runtime
