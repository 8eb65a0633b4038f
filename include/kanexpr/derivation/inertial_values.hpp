#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_inertia.hpp>
#include <kanexpr/mechanics/loads/bounded_value.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Masses and inertias that are expressions of parameters, such as m - 2*k, or whose validity depends on
/// numeric values, and values of loads that must be positive or not negative, stored as a sequence of
/// operations on numbers. Programs use this sequence to check the parameters that they receive. Bodies and
/// loads beyond its capacity are not checked.
struct inertial_values {
  static constexpr int room = 256, room_for_bodies = 32, room_for_names = 40, room_for_loads = 32;

  /// Each integer is the index of a step plus 1; 0 means that the value is unknown or needs no check.
  struct of_body {
    int called = 0, about = 0; ///< indices of names
    int mass = 0;
    int inertia[6]{}; ///< xx, yy, zz, xy, yz, zx
    int way[3]{}; ///< from the mass center to the point about which the inertia is given, in the same axes
  };

  /// A value of a load, such as a stiffness.
  struct of_load {
    base::name parameter{}; ///< empty if the value is an expression of several
    base::name called{};
    int value = 0;
    bool is_positive = false; ///< whether zero is a mistake too
  };

  int steps = 0;
  symbolic::operation operation[room]{};
  int a[room]{}; ///< for a symbol, the index of the parameter
  int b[room]{};
  double number[room]{};
  int count = 0;
  of_body bodies[room_for_bodies]{};
  int named = 0;
  base::name names[room_for_names]{}; ///< names of bodies and of reference points of inertias
  int bounded = 0;
  of_load loads[room_for_loads]{};

  /// Returns the first mistake for the given parameters: a value that is negative beyond rounding error, an
  /// inertia that no body can have, or a zero that must be positive. Values that depend on a NaN parameter
  /// are skipped.
  constexpr base::sentence mistake(const double* parameters) const {
    double value[room]{}, size[room]{}; // size: the magnitude of the terms that add up to a value
    for (int i = 0; i < steps; ++i) {
      const int left = is_leaf(operation[i]) ? 0 : a[i];
      value[i] = operation[i] == symbolic::operation::constant ? number[i]
                 : operation[i] == symbolic::operation::symbol
                     ? parameters[a[i]]
                     : value_of(operation[i], value[left], value[b[i]]);
      size[i] = magnitude(value[i]);
      if (operation[i] == symbolic::operation::add || operation[i] == symbolic::operation::subtract)
        size[i] = size[left] + size[b[i]];
      else if (operation[i] == symbolic::operation::negate)
        size[i] = size[left];
      else if (operation[i] == symbolic::operation::multiply)
        size[i] = size[left] * size[b[i]];
      else if (operation[i] == symbolic::operation::divide)
        size[i] = size[left] / magnitude(value[b[i]]);
    }
    const auto is_negative = [&](int step) {
      return step > 0 && numeric::is_finite(value[step - 1]) && value[step - 1] < -rounding * size[step - 1];
    };
    base::sentence found;
    for (int i = 0; i < count && !found; ++i) {
      const of_body& each = bodies[i];
      if (is_negative(each.mass))
        found = base::sentence({"the mass of ", names[each.called].view(), " is negative"});
      else if (is_negative(each.inertia[0]) || is_negative(each.inertia[1]) || is_negative(each.inertia[2]))
        found = base::sentence({"a moment of inertia of ", names[each.called].view(), " is negative"});
      else
        found = mistake_in_inertia(each, value);
    }
    for (int i = 0; i < bounded && !found; ++i) {
      const of_load& each = loads[i];
      const bool is_zero = each.is_positive && base::equal(value[each.value - 1], 0.0);
      if (is_zero || is_negative(each.value))
        found = base::sentence({each.parameter.length > 0 ? "parameter " : "", each.parameter.view(),
                                each.parameter.length > 0 ? ", " : "", each.called.view(),
                                each.parameter.length > 0 ? "," : "",
                                is_zero || each.is_positive ? " is not positive" : " is negative"});
    }
    return found;
  }

private:
  static constexpr double rounding = 1e-12;
  static constexpr double magnitude(double x) { return x < 0 ? -x : x; }

  constexpr base::sentence mistake_in_inertia(const of_body& body, const double* value) const {
    double entry[6]{};
    for (int i = 0; i < 6; ++i) {
      if (body.inertia[i] == 0) return {};
      entry[i] = value[body.inertia[i] - 1];
      if (!numeric::is_finite(entry[i])) return {};
    }
    mechanics::detail::numeric_inertia inertia;
    for (int i = 0; i < 3; ++i) {
      inertia.at[i][i] = entry[i];
      inertia.at[i][(i + 1) % 3] = inertia.at[(i + 1) % 3][i] = entry[3 + i];
    }
    const double largest = inertia.largest();
    if (!(largest > 1e-100)) return {};
    inertia.scale(1 / largest);
    mechanics::detail::numeric_offset way;
    way.known = body.mass > 0;
    way.mass = way.known ? value[body.mass - 1] : 0;
    for (int i = 0; i < 3; ++i) {
      way.known = way.known && body.way[i] > 0;
      way.r[i] = way.known ? value[body.way[i] - 1] : 0;
      way.known = way.known && magnitude(way.r[i]) < 1e30; // otherwise its square might overflow
    }
    way.known = way.known && way.mass < 1e30;
    return mechanics::detail::check_principal_values(names[body.called].view(), names[body.about].view(),
                                                     inertia, largest, way);
  }
};

/// Collects the inertial values of a mechanism.
class inertial_values_reader {
public:
  constexpr inertial_values_reader(const mechanics::mechanism& m, inertial_values& into)
      : m_(m), g_(*m.g), into_(into) {}

  constexpr void read() {
    for (const mechanics::body& b : m_.bodies) add(b);
  }
  constexpr void read(const mechanics::sequence<mechanics::bounded_value>& all) {
    for (const mechanics::bounded_value& each : all) add(each);
  }

private:
  using expression = symbolic::expression;

  constexpr void add(const mechanics::bounded_value& each) {
    if (into_.bounded == inertial_values::room_for_loads || each.value.is_constant()) return;
    const int value = place_of(each.value);
    if (value == 0) return;
    inertial_values::of_load& made = into_.loads[into_.bounded++];
    made.value = value, made.is_positive = each.is_positive;
    if (m_.parameters.find(each.value) >= 0) made.parameter = base::name(mechanics::called(m_, each.value));
    made.called = base::name(without_preposition(each.of));
  }
  /// "the stiffness" for "the stiffness of the ", whose sentence continues with the name of a load.
  static constexpr std::string_view without_preposition(std::string_view of) {
    for (const std::string_view end : {" the ", " ", " between", " with", " of"})
      if (of.ends_with(end)) of.remove_suffix(end.size());
    return of;
  }

  constexpr void add(const mechanics::body& b) {
    const bool is_inertia_asked = has_inertia_to_ask(b), is_mass_asked = !is_leaf(g_[b.mass.node()].op);
    if (into_.count == inertial_values::room_for_bodies || !has_room_for_names()) return;
    if (!is_inertia_asked && !is_mass_asked) return;
    inertial_values::of_body& made = into_.bodies[into_.count++];
    made.called = place_of(b.called);
    if (is_mass_asked) made.mass = place_of(b.mass);
    if (!is_inertia_asked) return;
    const mechanics::matrix3& inertia = b.inertia.parts[0].value;
    for (int i = 0; i < 3; ++i) {
      made.inertia[i] = place_of(inertia(i, i));
      made.inertia[3 + i] = place_of(inertia(i, (i + 1) % 3));
    }
    if (b.about != mechanics::none && b.about != b.center) add_way(b, made);
  }
  /// Whether a body has an inertia to check: a purely numeric inertia was already checked when the model was
  /// read, and an effective inertia is never checked.
  static constexpr bool has_inertia_to_ask(const mechanics::body& b) {
    if (b.inertia.parts.size() != 1 || b.effective) return false;
    const mechanics::dyadic::part& only = b.inertia.parts[0];
    bool is_of_numbers = true;
    for (int i = 0; i < 9; ++i) is_of_numbers = is_of_numbers && only.value(i / 3, i % 3).is_constant();
    return only.left == only.right && !is_of_numbers;
  }
  constexpr void add_way(const mechanics::body& b, inertial_values::of_body& made) {
    made.about = place_of(m_.points[b.about].called);
    mechanics::vector way;
    if (!mechanics::detail::find_offset(m_, b, way)) return;
    const int axes = b.inertia.parts[0].left;
    int places[3]{};
    for (int i = 0; i < 3; ++i) places[i] = place_of(expression(*m_.g, symbolic::graph::zero));
    for (const mechanics::vector::part& p : way.parts)
      for (int i = 0; i < 3 && !p.value.is_zero(); ++i) {
        if (p.frame != axes) return;
        places[i] = place_of(p.value[i]);
      }
    if (made.mass == 0) made.mass = place_of(b.mass);
    for (int i = 0; i < 3; ++i) made.way[i] = places[i];
  }

  /// Whether there is room for the names of a body and a point.
  constexpr bool has_room_for_names() const { return into_.named + 2 <= inertial_values::room_for_names; }
  constexpr int place_of(const base::name& called) {
    into_.names[into_.named] = called;
    return into_.named++;
  }

  /// The step that computes a value, counted from 1; 0 if the value depends on anything other than
  /// parameters, or if the arrays are full.
  constexpr int place_of(const expression& value) {
    const int known = nodes_.size();
    const int step = step_of(value.node());
    if (step < 0) {
      while (nodes_.size() > known) nodes_.pop();
      into_.steps = known;
    }
    return step + 1;
  }

  /// The step that computes a node, or -1 if the node depends on anything other than parameters or is not a
  /// plain number.
  constexpr int step_of(int id) {
    if (const int known = nodes_.find(id); known >= 0) return known;
    const symbolic::node n = g_[id];
    if (n.op >= symbolic::operation::pair) return -1;
    int a = 0, b = 0;
    if (n.op == symbolic::operation::symbol) {
      a = m_.parameters.find({*m_.g, id});
    } else if (n.op != symbolic::operation::constant) {
      a = step_of(n.a);
      b = a >= 0 && symbolic::is_binary(n.op) ? step_of(n.b) : 0;
    }
    if (a < 0 || b < 0 || into_.steps == inertial_values::room) return -1;
    into_.operation[into_.steps] = n.op;
    into_.a[into_.steps] = a;
    into_.b[into_.steps] = b;
    into_.number[into_.steps] = n.op == symbolic::operation::constant ? g_.number_at(id).value() : 0;
    ++into_.steps;
    nodes_.push(id);
    return into_.steps - 1;
  }

  const mechanics::mechanism& m_;
  const symbolic::graph& g_;
  inertial_values& into_;
  base::sequence<int> nodes_{}; ///< of each step
};

} // namespace kanexpr::derivation
