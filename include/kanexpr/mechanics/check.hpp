#pragma once

#include <kanexpr/mechanics/kinematic_equations.hpp>
#include <kanexpr/mechanics/problem.hpp>

/// Mistakes that a mechanism can hold, found before anything is derived from it.
namespace kanexpr::mechanics {

namespace detail {

/// Which symbols an expression holds; each node is looked at once.
class dependence {
public:
  constexpr explicit dependence(expression in) : g_(in.owner()), seen_(in.node() + 1, 0) { mark(in.node()); }

  constexpr bool on(expression symbol) const { return symbol.node() < seen_.size() && seen_[symbol.node()] != 0; }

  /// The first of some symbols that the expression holds, or none.
  constexpr int first_of(const sequence<expression>& symbols) const {
    for (int i = 0; i < symbols.size(); ++i)
      if (on(symbols[i])) return i;
    return none;
  }

private:
  constexpr void mark(int id) {
    if (seen_[id] != 0) return;
    seen_[id] = 1;
    const symbolic::node& n = g_[id];
    if (symbolic::is_leaf(n.op)) return;
    mark(n.a);
    if (symbolic::is_binary(n.op)) mark(n.b);
  }

  const graph& g_;
  sequence<char> seen_;
};

/// The checks of one mechanism, in the order in which a person would want to hear of mistakes.
class checking {
public:
  constexpr explicit checking(const mechanism& m) : m_(m) {}

  constexpr problem run() {
    counts();
    kinematic_equations();
    for (const frame& f : m_.frames) check(f);
    for (const point& p : m_.points) check(p);
    for (const body& b : m_.bodies) check(b);
    for (const force& f : m_.forces) rates_in(f.value, "the force at ", m_.points[f.point].called);
    for (const torque& t : m_.torques) rates_in(t.value, "the torque on ", m_.frames[t.frame].called);
    return found_;
  }

private:
  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }
  constexpr std::string_view called(expression symbol) const {
    return m_.g->symbol_at(symbol.node()).called.view();
  }
  constexpr void counts() {
    if (m_.speeds.empty()) return fail({"the system has no generalized speed"});
    if (m_.bodies.empty()) return fail({"the system has no particle and no rigid body"});
  }

  constexpr void kinematic_equations() {
    for (const expression& q : m_.coordinate_rates)
      if (!appears(q)) return fail({"coordinate ", called(q), " has its rate in no kinematic differential equation"});
    for (const expression& u : m_.speeds)
      if (!appears(u)) return fail({"speed ", called(u), " appears in no kinematic differential equation"});
    if (m_.kinematics.size() != m_.coordinates.size()) {
      const name q = number(m_.coordinates.size()), e = number(m_.kinematics.size());
      return fail({"the number of kinematic differential equations is ", e.view(), ", that of coordinates ", q.view()});
    }
    for (const expression& equation : m_.kinematics) {
      const dependence held(equation);
      const int acceleration = held.first_of(m_.speed_rates);
      if (acceleration != none)
        return fail({"a kinematic differential equation holds the rate of speed ", called(m_.speeds[acceleration])});
      if (!linear_in(equation, m_.coordinate_rates, "the rate of coordinate ")) return;
      if (!linear_in(equation, m_.speeds, "speed ")) return;
    }
    solvable();
  }

  static constexpr name number(int n) {
    name text;
    text.append(n);
    return text;
  }

  constexpr bool appears(expression symbol) const {
    for (const expression& equation : m_.kinematics)
      if (dependence(equation).on(symbol)) return true;
    return false;
  }

  constexpr bool linear_in(expression e, const sequence<expression>& symbols, std::string_view what) {
    for (const expression& s : symbols) {
      if (!dependence(e).on(s)) continue;
      const dependence slope(symbolic::differentiate(e, s));
      if (slope.first_of(symbols) == none) continue;
      fail({"a kinematic differential equation is not linear in ", what, called(s)});
      return false;
    }
    return true;
  }

  constexpr void solvable() {
    const linear_kinematics k = linear_in_rates(m_);
    const int n = k.k_rates.rows;
    if (n <= 8 && symbolic::determinant(*m_.g, k.k_rates).is_zero())
      fail({"the kinematic differential equations cannot be solved for the rates of the coordinates"});
  }

  /// Geometry may hold coordinates, parameters and time, nothing that has no rate.
  constexpr void geometry(expression e, std::string_view of, const name& whose) {
    const dependence held(e);
    const int u = held.first_of(m_.speeds), r = held.first_of(m_.inputs);
    if (u != none) fail({of, whose.view(), " holds the speed ", called(m_.speeds[u])});
    if (r != none) fail({of, whose.view(), " holds the input ", called(m_.inputs[r]), ", whose rate is not known"});
    if (held.first_of(m_.coordinate_rates) != none || held.first_of(m_.speed_rates) != none)
      fail({of, whose.view(), " holds the rate of a coordinate or speed"});
  }

  constexpr void check(const frame& f) {
    if (f.kind == orientation::about_basis || f.kind == orientation::about_axis)
      geometry(f.angle, "the angle of frame ", f.called);
    if (f.kind == orientation::matrix)
      for (int i = 0; i < 9; ++i) geometry(f.to_parent(i / 3, i % 3), "the orientation of frame ", f.called);
    if (f.turns_by_declaration()) velocity(f.angular_velocity, "the angular velocity of ", f.called);
  }

  constexpr void check(const point& p) {
    for (const vector::part& part : p.offset.parts)
      for (int i = 0; i < 3; ++i) geometry(part.value[i], "the offset of point ", p.called);
    if (p.moves_by_declaration()) velocity(p.velocity, "the velocity of ", p.called);
  }

  constexpr void velocity(const vector& v, std::string_view of, const name& whose) {
    for (const vector::part& part : v.parts)
      for (int i = 0; i < 3; ++i) {
        const dependence held(part.value[i]);
        const int r = held.first_of(m_.inputs);
        if (r != none) fail({of, whose.view(), " holds the input ", called(m_.inputs[r]), ", whose rate is not known"});
        for (const expression& u : m_.speeds)
          if (held.on(u) && dependence(symbolic::differentiate(part.value[i], u)).first_of(m_.speeds) != none)
            fail({of, whose.view(), " is not linear in speed ", called(u)});
      }
  }

  constexpr void rates_in(const vector& v, std::string_view of, const name& whose) {
    for (const vector::part& part : v.parts)
      for (int i = 0; i < 3; ++i) {
        const int a = dependence(part.value[i]).first_of(m_.speed_rates);
        if (a != none) fail({of, whose.view(), " holds the rate of speed ", called(m_.speeds[a])});
      }
  }

  constexpr void constant_content(expression e, std::string_view of, const name& whose) {
    const dependence held(e);
    if (held.first_of(m_.coordinates) != none || held.first_of(m_.speeds) != none || held.on(m_.time) ||
        held.first_of(m_.inputs) != none)
      fail({of, whose.view(), " changes in time"});
  }

  constexpr void check(const body& b) {
    if (b.mass.is_zero()) fail({"body ", b.called.view(), " has no mass"});
    if (b.mass.is_constant() && m_.g->number_at(b.mass.node()).negative())
      fail({"body ", b.called.view(), " has a negative mass"});
    constant_content(b.mass, "the mass of ", b.called);
    for (const dyadic::part& p : b.inertia.parts)
      for (int i = 0; i < 9; ++i) constant_content(p.value(i / 3, i % 3), "the inertia of ", b.called);
  }

  const mechanism& m_;
  problem found_;
};

} // namespace detail

/// The first mistake of a mechanism, or nothing.
constexpr problem check(const mechanism& m) { return detail::checking(m).run(); }

/// A mistake that shows only in the mass matrix.
constexpr problem check_mass_matrix(const mechanism& m, const symbolic::matrix& mass) {
  for (int i = 0; i < mass.rows; ++i)
    if (mass(i, i).is_zero())
      return sentence({"speed ", m.g->symbol_at(m.speeds[i].node()).called.view(), " moves no mass"});
  return {};
}

} // namespace kanexpr::mechanics
