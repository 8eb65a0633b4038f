#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/inward_steps.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// The composite body outward of a station that moves with a frame: its mass properties and, for each speed
/// whose motion enters farther out, the inertia force and moment per unit of the rate of the speed.
struct composite {
  struct column {
    int speed = none;
    vector force{};      ///< stays in its original axes as long as possible
    components moment{}; ///< about the station, on the frame
  };
  int frame = mechanism::inertial;
  rigid_mass mass{};
  sequence<column> columns{};
};

/// M = Σ J_iᵀ M_i J_i by composite bodies (Featherstone 2008, section 6.2), for any tree of frames, any tree
/// of points and any generalized speeds. The velocity that a frame or a point adds to that of its parent is
/// given by a few columns; each column is multiplied by the composite body where it enters and by all columns
/// farther outward.
class mass_matrix_builder {
public:
  enum class extent : unsigned char { whole, diagonal };

  /// Of a system with flexible bodies, the whole matrix must be formed.
  constexpr explicit mass_matrix_builder(const skeleton& s, extent wanted = extent::whole)
      : s_(s), m_(*s.model), at_(s_.stations.size()), result_(*m_.g, m_.ways(), m_.ways()),
        is_carried_(m_.ways(), wanted == extent::whole ? 1 : 0), is_whole_(wanted == extent::whole) {
    if (!is_whole_) carry_speeds_of_several_motions();
    for (const mechanics::link& l : s_.base_links) {
      composite& c = composite_of(l.station, l.frame);
      const path to_working(m_, s_.body_axes[l.frame], s_.working_axes[l.frame]);
      rigid_mass mass = l.mass;
      mass.first_moment = to_working.turn(mass.first_moment);
      mass.inertia = to_working.turn(mass.inertia);
      c.mass += mass;
    }
    for (const flexible_part& p : s_.flexible_parts) add(p);
  }

  /// Returns the full symmetric matrix.
  constexpr const symbolic::matrix& run() {
    for (const inward_step& each : inward_steps(s_))
      each.is_rotation() ? fold_frame(each) : fold_station(each.station);
    for (int i = 0; i < result_.rows; ++i)
      for (int j = 0; j < i; ++j) result_(j, i) = result_(i, j);
    for (int i = m_.speeds_of_motion(); i < m_.speeds.size(); ++i) result_(i, i) = m_.one();
    return result_;
  }

private:
  constexpr composite& composite_of(int n, int frame) {
    for (composite& c : at_[n])
      if (c.frame == frame) return c;
    composite fresh;
    fresh.frame = frame;
    fresh.mass = rigid_mass(*m_.g);
    at_[n].push(fresh);
    return at_[n].back();
  }

  /// For the diagonal, the columns of speeds that enter once are not needed farther inward.
  constexpr void carry_speeds_of_several_motions() {
    sequence<char> is_known(m_.ways(), 0);
    for (const auto* each : {&s_.partial_angular_velocities, &s_.partial_velocities})
      for (const sequence<partial_velocity>& partials : *each)
        for (const partial_velocity& v : partials)
          (is_known[v.speed] != 0 ? is_carried_ : is_known)[v.speed] = 1;
  }

  constexpr bool is_wanted(int i, int j) const { return is_whole_ || i == j; }

  constexpr void add(int i, int j, expression term) {
    i >= j ? result_(i, j) += term : result_(j, i) += term;
  }

  /// Adds the product of a column and a direction of speed `i`.
  constexpr void meet(int i, const composite::column& c, expression term) {
    add(i, c.speed, i == c.speed ? 2 * term : term);
  }

  static constexpr composite::column& column_of(composite& c, int speed, graph& g) {
    for (composite::column& present : c.columns)
      if (present.speed == speed) return present;
    c.columns.push({speed, vector(), components(g)});
    return c.columns.back();
  }

  /// Adds a flexible body to the composite body of its frame. Its amplitudes move no other body, so they are
  /// multiplied only by each other and by the motion of the frame.
  constexpr void add(const flexible_part& p) {
    composite& c = composite_of(p.station, p.frame);
    const path to_working(m_, p.axes, s_.working_axes[p.frame]);
    c.mass.mass += p.mass.mass;
    c.mass.first_moment += to_working.turn(p.mass.first_moment);
    c.mass.inertia = c.mass.inertia + to_working.turn(p.mass.inertia);
    for (int k = 0; k < p.amplitudes.size(); ++k)
      for (const flexible_part::rate_partial& r : p.amplitudes[k].partials) {
        composite::column& sum = column_of(c, r.speed, *m_.g);
        sum.force.add(p.axes, r.value * p.total_translation(k));
        sum.moment += to_working.turn(r.value * p.total_rotation(k));
        for (int l = 0; l < p.amplitudes.size(); ++l)
          for (const flexible_part::rate_partial& t : p.amplitudes[l].partials)
            if (r.speed >= t.speed)
              result_(r.speed, t.speed) += (r.value * t.value) * p.total_modal_mass(k, l);
      }
  }

  /// Moves the composite body of a frame to the frame in which it rotates.
  constexpr void fold_frame(const inward_step& now) {
    const int n = now.station, f = now.frame, below = now.below;
    composite c = composite_of(n, f);
    const sequence<partial_velocity>& partials = s_.partial_angular_velocities[f];
    sequence<composite::column> entering;
    for (const partial_velocity& w : partials)
      entering.push({w.speed, in_axes(s_.working_axes[f], cross(w.value, c.mass.first_moment)),
                     c.mass.inertia * w.value});
    enter(c, partials, entering, none);

    const int into = below == mechanism::inertial ? s_.stations[n].axes : below;
    const path way(m_, s_.working_axes[f], s_.working_axes[into]);
    composite& to = composite_of(n, below);
    to.mass.mass += c.mass.mass;
    if (below != mechanism::inertial) {
      to.mass.first_moment += way.turn(c.mass.first_moment);
      to.mass.inertia = to.mass.inertia + way.turn(c.mass.inertia);
    }
    for (const composite::column& k : c.columns) {
      composite::column& sum = column_of(to, k.speed, *m_.g);
      sum.force.add(k.force);
      if (below != mechanism::inertial) sum.moment += way.turn(k.moment);
    }
  }

  /// Moves all composite bodies at station `n` to its parent.
  constexpr void fold_station(int n) {
    const station& at = s_.stations[n];
    composite c = composite_of(n, at.frame);
    if (at.frame !=
        mechanism::inertial) { // composites in the ground's axes consist of a mass and forces only
      const composite& fixed = composite_of(n, mechanism::inertial);
      c.mass.mass += fixed.mass.mass;
      for (const composite::column& k : fixed.columns) column_of(c, k.speed, *m_.g).force.add(k.force);
    }
    if (c.mass.is_zero() && c.columns.empty()) return;
    if (!at.relative_velocity.parts.empty()) {
      const sequence<partial_velocity>& partials = s_.partial_velocities[n];
      sequence<composite::column> entering;
      const int axes = s_.working_axes[at.axes];
      for (const partial_velocity& v : partials)
        entering.push({v.speed, in_axes(axes, c.mass.mass * v.value), cross(c.mass.first_moment, v.value)});
      enter(c, partials, entering, axes);
    }
    if (at.absolute || at.parent == none) return;

    const components r = s_.offset_in_working_axes(n);
    composite& to = composite_of(at.parent, at.frame);
    if (at.frame == mechanism::inertial) {
      to.mass.mass += c.mass.mass;
      for (const composite::column& k : c.columns) column_of(to, k.speed, *m_.g).force.add(k.force);
      return;
    }
    to.mass += shifted(c.mass, r);
    const int axes = s_.working_axes[at.frame];
    for (const composite::column& k : c.columns) {
      const components force = express(m_, k.force, axes);
      composite::column& sum = column_of(to, k.speed, *m_.g);
      sum.force.add(in_axes(axes, force));
      sum.moment += k.moment + cross(r, force);
    }
  }

  static constexpr vector in_axes(int axes, const components& value) {
    vector v;
    v.add(axes, value);
    return v;
  }

  /// Multiplies new columns by each other and by the existing ones: rotations by moments, and translations,
  /// given in `axes`, by forces.
  constexpr void enter(composite& c, const sequence<partial_velocity>& ways,
                       const sequence<composite::column>& entering, int axes) {
    const auto felt = [&](const composite::column& k) {
      if (axes == none) return k.moment;
      return express(m_, k.force, axes);
    };
    for (int i = 0; i < ways.size(); ++i) {
      for (int j = 0; j <= i; ++j)
        if (is_wanted(ways[i].speed, ways[j].speed))
          add(ways[i].speed, ways[j].speed, dot(ways[j].value, felt(entering[i])));
      for (const composite::column& k : c.columns)
        if (is_wanted(ways[i].speed, k.speed)) meet(ways[i].speed, k, dot(ways[i].value, felt(k)));
    }
    for (const composite::column& k : entering) {
      if (is_carried_[k.speed] == 0) continue;
      composite::column& sum = column_of(c, k.speed, *m_.g);
      sum.force.add(k.force);
      sum.moment += k.moment;
    }
  }

  const skeleton& s_;
  const mechanism& m_;
  sequence<sequence<composite>> at_;
  symbolic::matrix result_;
  sequence<char> is_carried_; ///< by speed
  bool is_whole_;
};

} // namespace kanexpr::mechanics
