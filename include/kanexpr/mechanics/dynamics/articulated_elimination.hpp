#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/inward_steps.hpp>
#include <kanexpr/mechanics/model/articulated_mass.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// A speed that has been eliminated from M u̇ = f, and its column divided by the pivot: the force and moment
/// on the body in which it was eliminated, and the factors of the speeds that are eliminated later.
struct eliminated_speed {
  struct factor {
    int speed = none;
    expression value{};
  };
  int speed = none;
  expression inverse{}; ///< of the pivot
  components force{}, moment{};
  sequence<factor> factors{};
};

/// The speeds that are eliminated in one step.
struct elimination_step {
  inward_step motion{};
  sequence<eliminated_speed> from_outward{}; ///< before the motion; their forces act on the body outward
  sequence<eliminated_speed> from_inward{};  ///< after it; their forces act on the body inward
};

/// The elimination of M from the tips inward, without forming M (Featherstone 2008, chapter 7). The
/// acceleration of the next body inward adds six further unknowns to the equations of the speeds outward. A
/// speed is eliminated as soon as its whole column has reached one body, and the inertia of this body is
/// reduced; a column that other bodies share is carried inward until then.
class articulated_elimination {
public:
  constexpr explicit articulated_elimination(const skeleton& s)
      : s_(s), m_(*s.model), at_(s.stations.size()), mass_(*m_.g, m_.speeds.size(), m_.speeds.size()),
        motions_left_(m_.speeds.size(), 0), parts_(m_.speeds.size(), 0) {
    for (const link& l : s_.base_links) {
      const path to_working(m_, s_.body_axes[l.frame], s_.working_axes[l.frame]);
      rigid_mass mass = l.mass;
      mass.first_moment = to_working.turn(mass.first_moment);
      mass.inertia = to_working.turn(mass.inertia);
      body_at(l.station, l.frame).rigid += mass;
    }
    for (const inward_step& each : inward_steps(s_)) {
      steps_.push({each, {}, {}});
      for (const partial_velocity& v : entering(s_, each))
        if (v.speed < m_.speeds.size()) ++motions_left_[v.speed];
    }
    for (elimination_step& each : steps_) take(each);
    eliminate_rest();
  }

  constexpr const sequence<elimination_step>& steps() const { return steps_; }
  /// The speeds whose columns never reached one body.
  constexpr const sequence<eliminated_speed>& last() const { return last_; }
  constexpr const sequence<symbolic::pivot>& pivots() const { return pivots_; }

  /// The partial velocities or partial angular velocities of a step.
  static constexpr const sequence<partial_velocity>& entering(const skeleton& s, const inward_step& now) {
    return now.is_rotation() ? s.partial_angular_velocities[now.frame] : s.partial_velocities[now.station];
  }

  /// The axes in which the body that moves with a frame is given at a station.
  static constexpr int axes_of(const skeleton& s, int station, int frame) {
    return s.working_axes[frame == mechanism::inertial ? s.stations[station].axes : frame];
  }

private:
  /// The force and moment per unit of the rate of a speed.
  struct column {
    int speed = none;
    components force{}, moment{};
  };
  /// A body and the bodies outward, about a station and in its axes there. The rigid part is separate
  /// because it is cheaper to move.
  struct articulated_body {
    int frame = mechanism::inertial;
    rigid_mass rigid{};
    articulated_mass reduced{};
    bool is_reduced = false;
    sequence<column> columns{};
  };

  constexpr articulated_body& body_at(int n, int frame) {
    for (articulated_body& b : at_[n])
      if (b.frame == frame) return b;
    at_[n].push({frame, rigid_mass(*m_.g), articulated_mass(*m_.g), false, {}});
    return at_[n].back();
  }

  static constexpr column& column_of(sequence<column>& all, int speed, graph& g) {
    for (column& c : all)
      if (c.speed == speed) return c;
    all.push({speed, components(g), components(g)});
    return all.back();
  }
  /// Adds a part of a column to a body.
  constexpr void add(articulated_body& b, int speed, const components& force, const components& moment) {
    const int before = b.columns.size();
    column& sum = column_of(b.columns, speed, *m_.g);
    parts_[speed] += b.columns.size() - before;
    sum.force += force;
    sum.moment += moment;
  }

  constexpr void take(elimination_step& now) {
    const int n = now.motion.station, inward = now.motion.below;
    articulated_body b = body_at(n, now.motion.moved());
    if (!now.motion.is_rotation() && inward != mechanism::inertial) join_fixed(b, n);
    eliminate_complete(b, now.from_outward);
    if (!entering(s_, now.motion).empty()) {
      reduce(b);
      enter(b, now.motion);
      eliminate_complete(b, now.from_inward);
    }
    if (now.motion.is_rotation())
      join(body_at(n, inward), b, path(m_, s_.working_axes[b.frame], axes_of(s_, n, inward)));
    else
      move_to_parent(b, n);
  }

  /// Adds the bodies at a station that do not rotate with it.
  constexpr void join_fixed(articulated_body& b, int n) {
    const articulated_body fixed = body_at(n, mechanism::inertial);
    const path way(m_, axes_of(s_, n, mechanism::inertial), axes_of(s_, n, b.frame));
    b.rigid.mass += fixed.rigid.mass;
    b.is_reduced = b.is_reduced || fixed.is_reduced;
    if (fixed.is_reduced) b.reduced.mass = b.reduced.mass + way.turn(fixed.reduced.mass);
    for (const column& c : fixed.columns) {
      --parts_[c.speed];
      add(b, c.speed, way.turn(c.force), components(*m_.g));
    }
  }

  constexpr void move_to_parent(articulated_body& b, int n) {
    const station& at = s_.stations[n];
    if (at.absolute || at.parent == none) return;
    if (b.frame != mechanism::inertial) {
      const components r = s_.offset_in_working_axes(n);
      b.rigid = shifted(b.rigid, r);
      if (b.is_reduced) b.reduced = shifted(b.reduced, r);
      for (column& c : b.columns) c.moment += cross(r, c.force);
    }
    join(body_at(at.parent, b.frame), b, path(m_, axes_of(s_, n, b.frame), axes_of(s_, at.parent, b.frame)));
  }

  /// Adds a body to the next one inward. The ground takes any moment.
  constexpr void join(articulated_body& to, const articulated_body& b, const path& way) {
    const bool is_ground = to.frame == mechanism::inertial;
    to.rigid.mass += b.rigid.mass;
    if (!is_ground) {
      to.rigid.first_moment += way.turn(b.rigid.first_moment);
      to.rigid.inertia = to.rigid.inertia + way.turn(b.rigid.inertia);
    }
    to.is_reduced = to.is_reduced || b.is_reduced;
    if (b.is_reduced && is_ground) to.reduced.mass = to.reduced.mass + way.turn(b.reduced.mass);
    if (b.is_reduced && !is_ground) to.reduced += turned(way, b.reduced);
    for (const column& c : b.columns) {
      --parts_[c.speed];
      const components force = way.turn(c.force);
      components moment(*m_.g);
      if (!is_ground) moment = way.turn(c.moment);
      add(to, c.speed, force, moment);
    }
  }

  /// Treats the rigid part like the rest.
  constexpr void reduce(articulated_body& b) {
    articulated_mass all(b.rigid);
    if (b.is_reduced) all += b.reduced;
    b.reduced = all;
    b.rigid = rigid_mass(*m_.g);
    b.is_reduced = true;
  }

  /// Adds the columns of the speeds that enter with a motion, and their entries of M.
  constexpr void enter(articulated_body& b, const inward_step& now) {
    const auto felt = [&](const column& c) { return now.is_rotation() ? c.moment : c.force; };
    const articulated_mass& mass = b.reduced;
    const matrix3 across = transpose(mass.coupling);
    sequence<column> fresh;
    sequence<components> directions;
    for (const partial_velocity& v : entering(s_, now)) {
      if (v.speed >= m_.speeds.size()) continue;
      const components force = now.is_rotation() ? mass.coupling * v.value : mass.mass * v.value;
      const components moment = now.is_rotation() ? mass.inertia * v.value : across * v.value;
      for (const column& old : b.columns) {
        const expression product = dot(v.value, felt(old));
        add_entry(v.speed, old.speed, old.speed == v.speed ? 2 * product : product);
      }
      fresh.push({v.speed, force, moment});
      directions.push(v.value);
    }
    for (int i = 0; i < fresh.size(); ++i)
      for (int j = 0; j <= i; ++j)
        add_entry(fresh[i].speed, fresh[j].speed, dot(directions[i], felt(fresh[j])));
    for (const column& c : fresh) {
      --motions_left_[c.speed];
      add(b, c.speed, c.force, c.moment);
    }
  }

  constexpr void add_entry(int i, int j, expression term) {
    mass_(i, j) += term;
    if (i != j) mass_(j, i) = mass_(i, j);
  }

  /// Eliminates the speeds whose motions have all entered and whose columns are all in this body.
  constexpr void eliminate_complete(articulated_body& b, sequence<eliminated_speed>& into) {
    sequence<int> complete;
    for (const column& c : b.columns)
      if (motions_left_[c.speed] == 0 && parts_[c.speed] == 1) complete.push(c.speed);
    if (complete.empty()) return;
    if (!b.is_reduced) reduce(b);
    for (int i = complete.size() - 1; i >= 0; --i) into.push(eliminate(b, complete[i]));
  }

  /// Eliminates the speeds whose parts are attached to the ground at different places, and those without
  /// mass.
  constexpr void eliminate_rest() {
    articulated_body ground{mechanism::inertial, rigid_mass(*m_.g), articulated_mass(*m_.g), true, {}};
    for (int i = m_.speeds_of_motion() - 1; i >= 0; --i)
      if (parts_[i] != eliminated) last_.push(eliminate(ground, i));
  }

  /// Subtracts the share of a speed from the inertia, from the other columns and from M.
  constexpr eliminated_speed eliminate(articulated_body& b, int speed) {
    const expression pivot = mass_(speed, speed), inverse = 1 / pivot;
    symbolic::record_pivot(pivots_, speed, inverse, pivot, pivot);
    parts_[speed] = eliminated;
    const column own = taken(b, speed);
    eliminated_speed e{speed, inverse, over(own.force, pivot, inverse), over(own.moment, pivot, inverse), {}};
    for (int i = 0; i < 3; ++i) {
      b.reduced.coupling.row[i] -= e.force[i] * own.moment;
      for (int j = i; j < 3; ++j) {
        b.reduced.mass(i, j) -= e.force[i] * own.force[j];
        b.reduced.inertia(i, j) -= e.moment[i] * own.moment[j];
      }
    }
    for (int j = 0; j < mass_.rows; ++j) {
      const expression entry = mass_(speed, j);
      if (j == speed || parts_[j] == eliminated || entry.is_zero()) continue;
      const components force = -entry * e.force, moment = -entry * e.moment;
      add(b, j, force, moment);
      e.factors.push({j, over(entry, pivot, inverse)});
      for (const eliminated_speed::factor& f : e.factors) add_entry(j, f.speed, -(f.value * entry));
    }
    return e;
  }

  /// The column of a speed, which no longer belongs to the body.
  constexpr column taken(articulated_body& b, int speed) {
    column found{speed, components(*m_.g), components(*m_.g)};
    sequence<column> others;
    for (const column& c : b.columns)
      if (c.speed == speed)
        found = c;
      else
        others.push(c);
    b.columns = others;
    return found;
  }

  /// A quotient by the pivot, which is often an entry itself.
  constexpr expression over(expression e, expression pivot, expression inverse) const {
    if (e == pivot) return m_.one();
    return e == -pivot ? -m_.one() : e * inverse;
  }
  constexpr components over(const components& v, expression pivot, expression inverse) const {
    return {over(v.x, pivot, inverse), over(v.y, pivot, inverse), over(v.z, pivot, inverse)};
  }

  static constexpr int eliminated = -1;

  const skeleton& s_;
  const mechanism& m_;
  sequence<sequence<articulated_body>> at_;
  symbolic::matrix mass_;      ///< the entries of M so far, of the speeds not yet eliminated
  sequence<int> motions_left_; ///< by speed: the number of steps inward in which it enters
  sequence<int> parts_;        ///< by speed: the number of bodies that carry a part of its column
  sequence<elimination_step> steps_{};
  sequence<eliminated_speed> last_{};
  sequence<symbolic::pivot> pivots_{};
};

} // namespace kanexpr::mechanics
