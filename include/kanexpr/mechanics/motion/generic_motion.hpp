#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/derivatives/evaluate_rate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

/// The motion of the frames of a mechanism, evaluated numerically at generic states.
namespace kanexpr::mechanics {

/// Draws random configurations and speeds, solves the kinematic differential equations for the coordinate
/// rates, and evaluates the rotation of the frames, both from their orientations and from declared angular
/// velocities.
class generic_motion {
public:
  /// `more` contains additional expressions whose values and rates are needed.
  constexpr generic_motion(const mechanism& m, const contents& held, const sequence<expression>& more = {})
      : m_(m), g_(*m.g), equations_(g_, symbolic::nodes_of(m.kinematics)),
        scalars_(g_, nodes_of_frames(m, more)), symbols_(g_.size()), frames_(m.frames.size()) {
    sequence<int> in_equations;
    for (const expression& e : m.kinematics) {
      rates_.push({});
      held.collect(e, kind::coordinate_rate, rates_.back());
      held.collect(e, kind::speed, in_equations);
    }
    for (const expression& u : m.speeds)
      if (!in_equations.contains(u.node())) free_speeds_.push(u.node());
  }

  /// Draws a new configuration and new speeds.
  constexpr void draw() {
    for (const sequence<expression>* list : {&m_.coordinates, &m_.speeds, &m_.inputs})
      for (const expression& e : *list) symbols_[e.node()].value = 1.8 * random_.next() - 0.9;
    for (const expression& e : m_.parameters) symbols_[e.node()].value = 0.5 + random_.next();
    symbols_[m_.time.node()] = {1.8 * random_.next() - 0.9, 1};
    for (const frame& f : m_.frames) normalize(f.quaternion);
    for (const prescribed_rate& p : m_.prescribed_rates)
      symbols_[p.quantity.node()].rate = symbols_[p.rate.node()].value;
  }

  /// Sets all speeds except one to zero.
  constexpr void keep_only(expression speed) {
    for (const expression& u : m_.speeds)
      if (u != speed) symbols_[u.node()].value = 0;
  }

  /// Whether there are free speeds, which appear in no kinematic differential equation because they are the
  /// rates of angles that the model omits.
  constexpr bool has_free_speeds() const { return !free_speeds_.empty(); }

  /// Evaluates the motion for the drawn speeds, with or without the free ones. Returns false if it is
  /// undefined.
  constexpr bool move(bool with_free_speeds = true) {
    sequence<double> kept;
    for (int id : free_speeds_) {
      kept.push(symbols_[id].value);
      if (!with_free_speeds) symbols_[id].value = 0;
    }
    const bool defined = solve_for_rates() && evaluate();
    for (int i = 0; i < kept.size(); ++i) symbols_[free_speeds_[i]].value = kept[i];
    return defined;
  }

  /// Draws states until the motion is defined at one; gives up after a few attempts.
  constexpr bool find_state(bool with_free_speeds = true) {
    for (int attempts = 0; attempts < 6; ++attempts) {
      draw();
      if (move(with_free_speeds)) return true;
    }
    return false;
  }

  /// Evaluates the motion for arbitrary coordinate rates, without the kinematic equations.
  constexpr bool move_freely() {
    for (const expression& rate : m_.coordinate_rates) symbols_[rate.node()].value = random_.next() - 0.5;
    follow_rates();
    return evaluate();
  }

  /// Whether the basis of a frame is orthonormal; for quaternions and matrices, this depends on their values.
  constexpr bool is_proper(int f) const { return frames_[f].proper; }
  /// The basis vectors of a frame in inertial axes.
  constexpr const triad& basis(int f) const { return frames_[f].basis; }
  /// The angular velocity of a frame in the inertial frame, from the orientations.
  constexpr triple by_orientation(int f) const { return frames_[f].by_orientation; }
  /// The angular velocity of a frame in the inertial frame, as used in the equations of motion.
  constexpr triple angular_velocity(int f) const { return frames_[f].angular_velocity; }
  /// The rounding error to expect in an angular velocity that is exactly zero, if all rates come from one
  /// linear solution.
  constexpr double rounding() const {
    double fastest = 0;
    for (const pose& p : frames_)
      for (const triple& w : {p.by_orientation, p.angular_velocity})
        if (length(w) > fastest) fastest = length(w);
    return 1e-14 * fastest;
  }
  /// The declared angular velocity of a frame in its reference.
  constexpr triple declared(int f) const { return vector_of(m_.frames[f].angular_velocity); }

  constexpr const symbolic::value_and_rate& at(int node) const { return scalars_[node]; }
  constexpr const symbolic::value_and_rate& operator[](expression e) const { return at(e.node()); }
  /// Whether an expression is finite at the drawn state; constant evaluation rejects computations with NaN or
  /// infinity.
  constexpr bool is_defined(expression e) const {
    return numeric::elementary::detail::is_finite((*this)[e].value) &&
           numeric::elementary::detail::is_finite((*this)[e].rate);
  }
  constexpr bool is_defined(const vector& v) const {
    for (const vector::part& p : v.parts)
      for (int i = 0; i < 3; ++i)
        if (!is_defined(p.value[i])) return false;
    return true;
  }
  constexpr triple vector_of(const vector& v) const {
    triple sum;
    for (const vector::part& p : v.parts) sum = sum + basis(p.frame) * value(p.value);
    return sum;
  }
  using angular_velocities = triple (generic_motion::*)(int) const;
  /// The rate of a vector in the inertial frame, if the frames rotate with the given angular velocities.
  constexpr triple rate_of(const vector& v, angular_velocities w) const {
    triple sum;
    for (const vector::part& p : v.parts) {
      const triad& axes = basis(p.frame);
      sum = sum + axes * rate(p.value) + cross((this->*w)(p.frame), axes * value(p.value));
    }
    return sum;
  }
  constexpr triple value(const components& c) const {
    return {(*this)[c.x].value, (*this)[c.y].value, (*this)[c.z].value};
  }
  constexpr triple rate(const components& c) const {
    return {(*this)[c.x].rate, (*this)[c.y].rate, (*this)[c.z].rate};
  }

private:
  using kind = symbolic::symbol_kind;

  struct pose {
    triad basis{};
    triple by_orientation{}, angular_velocity{};
    bool proper = true;
    bool known = false; ///< whether `angular_velocity` is known
  };

  /// The scalars from which the orientation of a frame is evaluated.
  static constexpr sequence<expression> scalars_of(const frame& f) {
    sequence<expression> all = f.scalars();
    for (int i = 0; i < 9 && f.kind == orientation::about_axis; ++i) all.push(f.to_parent(i / 3, i % 3));
    return all;
  }
  static constexpr sequence<int> nodes_of_frames(const mechanism& m, sequence<expression> all) {
    for (const frame& f : m.frames) {
      all.append(scalars_of(f));
      if (f.kind == orientation::about_axis)
        for (int i = 0; i < 3; ++i) all.push(f.direction[i]);
      push_entries(all, f.angular_velocity);
    }
    return symbolic::nodes_of(all);
  }

  constexpr bool is_defined(const frame& f) const {
    for (const expression& e : scalars_of(f))
      if (!is_defined(e)) return false;
    return is_defined(f.angular_velocity);
  }

  constexpr void set_rates(double value) {
    for (const expression& rate : m_.coordinate_rates) symbols_[rate.node()].value = value;
  }
  /// Moves the coordinates at the rates that were set.
  constexpr void follow_rates() {
    for (int q = 0; q < m_.coordinates.size(); ++q)
      symbols_[m_.coordinates[q].node()].rate = symbols_[m_.coordinate_rates[q].node()].value;
  }

  /// Normalizes a quaternion if its four entries are symbols.
  constexpr void normalize(const sequence<expression>& quaternion) {
    double square = 0;
    for (const expression& e : quaternion) {
      if (!m_.coordinates.contains(e)) return;
      square += symbols_[e.node()].value * symbols_[e.node()].value;
    }
    for (const expression& e : quaternion) symbols_[e.node()].value /= numeric::elementary::sqrt(square);
  }

  /// Solves the kinematic equations, which are linear in the rates; most contain a single rate.
  constexpr bool solve_for_rates() {
    const int n = m_.kinematics.size();
    set_rates(0);
    const sequence<double> at_rest = residuals();
    set_rates(1);
    const sequence<double> at_one = residuals();
    set_rates(0);
    sequence<int> coupled, known, unknown;
    for (int i = 0; i < n; ++i) {
      if (rates_[i].size() != 1) {
        coupled.push(i);
        continue;
      }
      if (base::equal(at_one[i], at_rest[i])) return false;
      known.push(rates_[i][0]);
      symbols_[known.back()].value = -at_rest[i] / (at_one[i] - at_rest[i]);
    }
    for (int i : coupled)
      for (int rate : rates_[i])
        if (!known.contains(rate) && !unknown.contains(rate)) unknown.push(rate);
    if (unknown.size() != coupled.size() || (!coupled.empty() && !solve_for(unknown, coupled))) return false;
    follow_rates();
    return true;
  }
  constexpr bool solve_for(const sequence<int>& unknown, const sequence<int>& coupled) {
    const int order = unknown.size();
    const numeric::factors place{order};
    sequence<double> f(place.size(), 0), x;
    const sequence<double> base = residuals();
    for (int i : coupled) x.push(-base[i]);
    for (int j = 0; j < order; ++j) {
      symbols_[unknown[j]].value = 1;
      const sequence<double> moved = residuals();
      symbols_[unknown[j]].value = 0;
      for (int i = 0; i < order; ++i) f[place.at(i, j)] = moved[coupled[i]] - base[coupled[i]];
    }
    numeric::factorize<numeric::constant_elimination_math>(order, &f[0]);
    if (!(f[place.least_pivot()] > 0)) return false;
    numeric::solve_factorized<numeric::constant_elimination_math>(order, &f[0], &x[0]);
    for (int j = 0; j < order; ++j) symbols_[unknown[j]].value = x[j];
    return true;
  }
  constexpr sequence<double> residuals() {
    equations_.at([&](int id) { return symbols_[id].value; });
    sequence<double> values;
    for (const expression& e : m_.kinematics) values.push(equations_[e.node()]);
    return values;
  }

  constexpr bool evaluate() {
    scalars_.at([&](int id) { return symbols_[id]; });
    for (const frame& f : m_.frames)
      if (!is_defined(f)) return false;
    for (int f = 0; f < frames_.size(); ++f) place(f);
    for (int f = 0; f < frames_.size(); ++f) {
      turn(f);
      const triple w = frames_[f].angular_velocity - frames_[f].by_orientation;
      if (!numeric::elementary::detail::is_finite(w.x + w.y + w.z)) return false;
    }
    return true;
  }

  /// Evaluates the basis of frame `f`; parents precede the frames oriented relative to them.
  constexpr void place(int f) {
    const frame& own = m_.frames[f];
    pose p;
    if (own.kind == orientation::inertial) {
      p.basis = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      frames_[f] = p;
      return;
    }
    const pose& below = frames_[own.parent];
    p.proper = below.proper;
    triple w; // in the parent's axes
    triad turned;
    if (own.kind == orientation::about_basis) {
      const symbolic::value_and_rate& angle = (*this)[own.angle];
      turned = about_basis(own.axis, angle.value);
      w = {own.axis == 0 ? angle.rate : 0, own.axis == 1 ? angle.rate : 0, own.axis == 2 ? angle.rate : 0};
    } else {
      const triad rows{value(own.to_parent.row[0]), value(own.to_parent.row[1]), value(own.to_parent.row[2])};
      const triad rates{rate(own.to_parent.row[0]), rate(own.to_parent.row[1]), rate(own.to_parent.row[2])};
      turned = transposed(rows);
      if (own.kind == orientation::about_axis)
        w = (*this)[own.angle].rate * value(own.direction);
      else
        w = 0.5 * axial(transposed(rates), turned), p.proper = p.proper && is_orthonormal(turned);
    }
    p.basis = below.basis * turned;
    p.by_orientation = below.by_orientation + below.basis * w;
    frames_[f] = p;
  }

  constexpr void turn(int f) {
    pose& p = frames_[f];
    if (p.known) return;
    p.known = true;
    const frame& own = m_.frames[f];
    if (own.has_declared_angular_velocity()) {
      turn(own.reference);
      p.angular_velocity = frames_[own.reference].angular_velocity + declared(f);
      p.proper = p.proper && frames_[own.reference].proper;
    } else if (own.parent != none) {
      turn(own.parent);
      p.angular_velocity =
          frames_[own.parent].angular_velocity + (p.by_orientation - frames_[own.parent].by_orientation);
    }
  }

  static constexpr triad about_basis(int axis, double angle) {
    const double s = numeric::elementary::sin(angle), c = numeric::elementary::cos(angle);
    if (axis == 0) return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
    if (axis == 1) return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
  }
  static constexpr triad transposed(const triad& t) {
    return {{t.x.x, t.y.x, t.z.x}, {t.x.y, t.y.y, t.z.y}, {t.x.z, t.y.z, t.z.z}};
  }
  /// Σ b × ḃ over the basis vectors is twice the angular velocity.
  static constexpr triple axial(const triad& rates, const triad& basis) {
    return cross(basis.x, rates.x) + cross(basis.y, rates.y) + cross(basis.z, rates.z);
  }
  static constexpr bool is_orthonormal(const triad& t) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        if (!(numeric::elementary::abs(dot(t[i], t[j]) - (i == j ? 1 : 0)) < 1e-9)) return false;
    return true;
  }

  const mechanism& m_;
  graph& g_;
  symbolic::evaluation equations_;
  symbolic::rate_evaluation scalars_;
  sequence<symbolic::value_and_rate> symbols_;
  sequence<pose> frames_;
  sequence<sequence<int>> rates_{}; ///< the coordinate rates in each equation
  sequence<int> free_speeds_{};
  random_numbers random_{};
};

} // namespace kanexpr::mechanics
