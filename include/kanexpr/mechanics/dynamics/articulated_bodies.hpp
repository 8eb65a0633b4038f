#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/articulated_elimination.hpp>
#include <kanexpr/mechanics/dynamics/inward_steps.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// Solves M u̇ = f by articulated bodies (Featherstone 2008, chapter 7), for any tree of frames, any tree of
/// points and any generalized speeds. The number of operations grows linearly with the length of a chain.
class articulated_bodies {
public:
  constexpr explicit articulated_bodies(const skeleton& s) : s_(s), m_(*s.model), elimination_(s) {}

  /// The solution for one right-hand side, with the pivots of the elimination.
  constexpr symbolic::symmetric_solution solve(const sequence<expression>& f) const {
    right_hand_side right{f, sequence<sequence<force_on_body>>(s_.stations.size())};
    for (const elimination_step& each : elimination_.steps()) reduce(each, right);
    force_on_body ground{none, components(*m_.g), components(*m_.g)};
    reduce_by(elimination_.last(), right.left, ground);

    symbolic::symmetric_solution solved{f, elimination_.pivots()};
    acceleration_of_bodies moved{sequence<components>(s_.stations.size(), components(*m_.g)),
                                 sequence<components>(m_.frames.size(), components(*m_.g))};
    find(elimination_.last(), right.left, components(*m_.g), components(*m_.g), solved.x);
    const sequence<elimination_step>& steps = elimination_.steps();
    for (int i = steps.size() - 1; i >= 0; --i) go_outward(steps[i], right.left, moved, solved.x);
    return solved;
  }

private:
  struct force_on_body {
    int frame = none;
    components force{}, moment{};
  };
  struct right_hand_side {
    sequence<expression> left{}; ///< f minus the shares of the eliminated speeds
    sequence<sequence<force_on_body>> forces{};
  };
  /// The accelerations that are linear in u̇: of the stations, and the angular ones of the frames.
  struct acceleration_of_bodies {
    sequence<components> of_stations{}, of_frames{};
  };

  constexpr int axes_of(int n, int frame) const { return articulated_elimination::axes_of(s_, n, frame); }

  constexpr force_on_body& force_at(right_hand_side& right, int n, int frame) const {
    for (force_on_body& f : right.forces[n])
      if (f.frame == frame) return f;
    right.forces[n].push({frame, components(*m_.g), components(*m_.g)});
    return right.forces[n].back();
  }

  // ---- inward: the shares of the eliminated speeds in the forces

  constexpr void reduce(const elimination_step& now, right_hand_side& right) const {
    const int n = now.motion.station, inward = now.motion.below;
    const bool rotates = now.motion.is_rotation();
    force_on_body p = force_at(right, n, now.motion.moved());
    if (!rotates && inward != mechanism::inertial) {
      const components fixed = force_at(right, n, mechanism::inertial).force;
      p.force += express(m_, fixed, axes_of(n, mechanism::inertial), axes_of(n, inward));
    }
    reduce_by(now.from_outward, right.left, p);
    for (const partial_velocity& v : articulated_elimination::entering(s_, now.motion))
      if (v.speed < m_.speeds.size()) right.left[v.speed] += dot(v.value, rotates ? p.moment : p.force);
    reduce_by(now.from_inward, right.left, p);
    rotates ? add(p, n, force_at(right, n, inward), n) : move_to_parent(p, n, right);
  }

  static constexpr void reduce_by(const sequence<eliminated_speed>& all, sequence<expression>& left,
                                  force_on_body& p) {
    for (const eliminated_speed& e : all) {
      p.force -= left[e.speed] * e.force;
      p.moment -= left[e.speed] * e.moment;
      for (const eliminated_speed::factor& f : e.factors) left[f.speed] -= f.value * left[e.speed];
    }
  }

  constexpr void move_to_parent(force_on_body& p, int n, right_hand_side& right) const {
    const station& at = s_.stations[n];
    if (at.absolute || at.parent == none) return;
    if (at.frame != mechanism::inertial) p.moment += cross(s_.offset_in_working_axes(n), p.force);
    add(p, n, force_at(right, at.parent, at.frame), at.parent);
  }

  constexpr void add(const force_on_body& p, int n, force_on_body& to, int station_of_sum) const {
    const int from = axes_of(n, p.frame), axes = axes_of(station_of_sum, to.frame);
    to.force += express(m_, p.force, from, axes);
    if (to.frame != mechanism::inertial) to.moment += express(m_, p.moment, from, axes);
  }

  // ---- outward: the rates of the speeds, and the accelerations

  constexpr void go_outward(const elimination_step& now, const sequence<expression>& left,
                            acceleration_of_bodies& moved, sequence<expression>& udot) const {
    const int n = now.motion.station, frame = now.motion.moved(), axes = axes_of(n, frame);
    const station& at = s_.stations[n];
    components a(*m_.g), alpha(*m_.g);
    if (now.motion.is_rotation()) {
      a = express(m_, moved.of_stations[n], s_.working_axes[at.axes], axes);
      const int inward = now.motion.below;
      if (inward != mechanism::inertial)
        alpha = express(m_, moved.of_frames[inward], s_.working_axes[inward], axes);
    } else {
      alpha = moved.of_frames[frame];
      if (!at.absolute && at.parent != none) a = carried(n, axes, alpha, moved);
    }
    find(now.from_inward, left, a, alpha, udot);
    for (const partial_velocity& v : articulated_elimination::entering(s_, now.motion))
      if (v.speed < m_.speeds.size())
        (now.motion.is_rotation() ? alpha : a) += scaled(udot[v.speed], v.value);
    find(now.from_outward, left, a, alpha, udot);
    if (now.motion.is_rotation())
      moved.of_frames[frame] = alpha;
    else
      moved.of_stations[n] = express(m_, a, axes, s_.working_axes[at.axes]);
  }

  /// The acceleration of a station that its parent and its frame give it.
  constexpr components carried(int n, int axes, const components& alpha,
                               const acceleration_of_bodies& moved) const {
    const station& at = s_.stations[n];
    components a =
        express(m_, moved.of_stations[at.parent], s_.working_axes[s_.stations[at.parent].axes], axes);
    if (at.frame != mechanism::inertial) a += cross(alpha, s_.offset_in_working_axes(n));
    return a;
  }

  /// The rates of eliminated speeds from the acceleration of the body on which their forces act.
  static constexpr void find(const sequence<eliminated_speed>& all, const sequence<expression>& left,
                             const components& a, const components& alpha, sequence<expression>& udot) {
    for (int i = all.size() - 1; i >= 0; --i) {
      const eliminated_speed& e = all[i];
      expression rate = left[e.speed] * e.inverse;
      rate -= dot(e.force, a);
      rate -= dot(e.moment, alpha);
      for (const eliminated_speed::factor& f : e.factors) rate -= f.value * udot[f.speed];
      udot[e.speed] = rate;
    }
  }

  const skeleton& s_;
  const mechanism& m_;
  articulated_elimination elimination_;
};

} // namespace kanexpr::mechanics
