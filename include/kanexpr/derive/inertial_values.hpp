#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>

namespace kanexpr::deriving {

/// Masses and moments of inertia that are expressions of parameters, such as m - 2*k: as steps on numbers,
/// for programs that look at the parameters which they are given. As many as there is room for.
struct inertial_values {
  static constexpr int room = 256, room_for_values = 64, room_for_bodies = 32;

  int steps = 0;
  symbolic::operation operation[room]{};
  int a[room]{}; ///< of a symbol: which parameter
  int b[room]{};
  double number[room]{};
  int count = 0;
  int step_of[room_for_values]{};
  bool is_moment[room_for_values]{};
  int body[room_for_values]{};
  int bodies = 0;
  symbolic::name names[room_for_bodies]{}; ///< of the bodies

  /// The first that is negative by more than rounding with some parameters, or -1.
  constexpr int first_negative(const double* parameters) const {
    double value[room]{}, size[room]{}; // size: of the terms that a value is the sum of
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
    for (int i = 0; i < count; ++i)
      if (value[step_of[i]] < -rounding * size[step_of[i]]) return i;
    return -1;
  }

private:
  static constexpr double rounding = 1e-12;
  static constexpr double magnitude(double x) { return x < 0 ? -x : x; }
};

/// Finds them in a mechanism.
class inertial_values_of {
public:
  constexpr inertial_values_of(const mechanics::mechanism& m, inertial_values& into)
      : m_(m), g_(*m.g), into_(into) {
    for (const mechanics::body& b : m.bodies) {
      add(b, b.mass, false);
      if (b.inertia.parts.size() != 1 || b.effective) continue;
      const mechanics::dyadic::part& only = b.inertia.parts[0];
      for (int i = 0; i < 3 && only.left == only.right; ++i) add(b, only.value(i, i), true);
    }
  }

private:
  constexpr void add(const mechanics::body& b, const symbolic::expression& value, bool is_moment) {
    if (is_leaf(g_[value.node()].op) || into_.count == inertial_values::room_for_values) return;
    const bool is_new = into_.bodies == 0 || !(into_.names[into_.bodies - 1] == b.called);
    if (is_new && into_.bodies == inertial_values::room_for_bodies) return;
    const int known = nodes_.size();
    const int step = step_of(value.node());
    if (step < 0) {
      while (nodes_.size() > known) nodes_.pop();
      into_.steps = known;
      return;
    }
    into_.step_of[into_.count] = step;
    into_.is_moment[into_.count] = is_moment;
    if (is_new) into_.names[into_.bodies++] = b.called;
    into_.body[into_.count] = into_.bodies - 1;
    ++into_.count;
  }

  /// The step that has the value of a node, or -1 where it is not of parameters alone, or is none of numbers.
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
  symbolic::sequence<int> nodes_{}; ///< by step
};

} // namespace kanexpr::deriving
