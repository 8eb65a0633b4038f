#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/flexible_inertia.hpp>
#include <kanexpr/mechanics/dynamics/inertia_moment.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Generalized forces Σ v_r·R + ω_r·T by reverse accumulation through the velocity map: forces are passed
/// down the tree of points, moments down the tree of frames, and each speed receives its contribution where
/// it enters. The cost is linear in the number of links. Definition: Kane & Levinson (1985), section 4.4.
class generalized_forces {
public:
  constexpr explicit generalized_forces(const skeleton& s)
      : s_(s), m_(*s.model), known_(m_, s.coordinate_rates), acting_(s) {}

  /// Adds all loads of the model, and gravity unless it is treated as an acceleration of the ground.
  constexpr void add_loads(const loads& given, bool gravity, conservative how = conservative::by_forces) {
    if (!given.state_rates.empty()) take_state_rates(given);
    given.each([&](const auto& load, int) { load.act(acting_, how); });
    acting_.differentiate_energies();
    if (gravity) add_gravity(given);
  }

  /// Adds the weights of all bodies.
  constexpr void add_gravity(const loads& given) {
    if (!given.has_gravity) return;
    for (const body& b : m_.bodies) acting_.add_force(b.center, b.mass * known_.in(given.gravity));
    for (const flexible_part& p : s_.flexible_parts)
      add(p, weight(p, express(m_, known_.in(given.gravity), p.axes)), m_.one());
  }

  /// Adds the inertia forces and moments of a motion.
  constexpr void add_inertia(motion& k) {
    for (const link& l : s_.base_links) {
      const int f = l.frame;
      const path to_working(m_, s_.body_axes[f], s_.working_axes[f]);
      const components h = to_working.turn(l.mass.first_moment);
      const symmetric inertia = to_working.turn(l.mass.inertia);
      const components a = k.acceleration(l.station, f);
      components demand = l.mass.mass * a;
      if (!h.is_zero()) demand += k.acceleration_matrix(f) * h;
      force_[l.station] -= k.turn(demand, f, s_.stations[l.station].axes);
      components moment = cross(h, a);
      moment += inertia_moment(k, inertia, f);
      moment_[f] -= moment;
    }
    for (const flexible_part& p : s_.flexible_parts) add(p, inertia_demand(k, p), -m_.one());
    if (m_.state_variables == 0) return;
    for (int i = m_.speeds_of_motion(); i < m_.speeds.size(); ++i) share_[i] -= k.rate(m_.speeds[i]);
  }

  /// Adds the forces due to changing masses and inertias, F = d(mv)/dt: −ṁ v at the mass center and −İ·ω.
  constexpr void add_changes_of_mass(motion& k) {
    for (const body& b : m_.bodies) add_change_of_mass(k, b);
  }
  /// Adds the forces of one body; returns true if the body contributes.
  constexpr bool add_change_of_mass(motion& k, const body& b) {
    const int n = s_.station_of_point[b.center];
    const expression rate = k.rate(known_.in(b.mass));
    if (!rate.is_zero()) force_[n] -= rate * k.velocity(n);
    if (b.frame == none || (rate.is_zero() && has_fixed_inertia(k, b))) return !rate.is_zero();
    const int f = s_.rigid_with[b.frame], axes = s_.body_axes[f];
    const components w = express(m_, k.angular_velocity(f), s_.working_axes[f], axes);
    const symmetric change = rate_in_body(k, central_inertia(m_, b, axes), axes, f, w);
    if (change.is_zero()) return !rate.is_zero();
    moment_[f] -= express(m_, change * w, axes, s_.working_axes[f]);
    return true;
  }

  /// Returns the generalized force of each speed, followed by those of the auxiliary speeds.
  constexpr const sequence<expression>& run() {
    for (int n = s_.stations.size() - 1; n >= 0; --n) {
      const station& at = s_.stations[n];
      if (force_[n].is_zero()) continue;
      for (const partial_velocity& v : s_.partial_velocities[n]) share_[v.speed] += dot(v.value, force_[n]);
      if (at.absolute || at.parent == none) continue;
      moment_[at.frame] += cross(s_.offset_in_working_axes(n), force_[n]);
      const int parent_axes = s_.stations[at.parent].axes;
      force_[at.parent] += turn(force_[n], at.axes, parent_axes);
    }
    for (int f : s_.frames_tips_first()) {
      if (moment_[f].is_zero()) continue;
      for (const partial_velocity& w : s_.partial_angular_velocities[f])
        share_[w.speed] += dot(w.value, moment_[f]);
      const int below = s_.turns_in[f];
      if (below != mechanism::inertial) moment_[below] += turn(moment_[f], f, below);
    }
    return share_;
  }

private:
  /// Lets loads use the rates of the state variables.
  constexpr void take_state_rates(const loads& given) {
    sequence<state_rate> all;
    for (const state_rate& each : given.state_rates)
      if (!each.is_of_load()) all.push(each);
    given.each_kind([&](const auto& loads_of_kind) {
      for (const auto& load : loads_of_kind)
        if constexpr (requires { load.add_state_rates(acting_, all); }) load.add_state_rates(acting_, all);
    });
    const sequence<expression> rates = resolved_state_rates(m_, all);
    for (int i = 0; i < rates.size(); ++i) acting_.replace(m_.speed_rates[all[i].speed], known_.in(rates[i]));
  }

  constexpr components turn(const components& v, int from, int to) const {
    return express(m_, v, s_.working_axes[from], s_.working_axes[to]);
  }

  /// Adds a multiple of a load on a flexible body.
  constexpr void add(const flexible_part& p, const flexible_load& load, expression factor) {
    const int axes = s_.stations[p.station].axes;
    force_[p.station] += factor * express(m_, load.force, p.axes, s_.working_axes[axes]);
    moment_[p.frame] += factor * express(m_, load.moment, p.axes, s_.working_axes[p.frame]);
    for (int k = 0; k < p.amplitudes.size(); ++k)
      for (const flexible_part::rate_partial& by : p.amplitudes[k].partials)
        share_[by.speed] += factor * (by.value * load.on_amplitudes[k]);
  }

  /// Whether the inertia of a body is given by constants in its own axes.
  constexpr bool has_fixed_inertia(motion& k, const body& b) {
    bool is_fixed = s_.has_own_axes(b);
    b.inertia.each_entry([&](expression e) { is_fixed = is_fixed && k.rate(e).is_zero(); });
    return is_fixed;
  }

  /// The rate of an inertia given in the axes of frame `axes`, relative to the body that moves with frame `f`
  /// and rotates at `w`: İ + W I + (W I)ᵀ with W = [ω_axes − ω]×. It vanishes if the body is rotationally
  /// symmetric about the axis of this rotation.
  constexpr symmetric rate_in_body(motion& k, const symmetric& inertia, int axes, int f,
                                   const components& w) {
    symmetric change(*m_.g);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) change(i, j) = k.rate(known_.in(inertia(i, j)));
    if (s_.rigid_with[axes] == f) return change;
    const components angular_velocity =
        express(m_, k.angular_velocity(axes), s_.working_axes[axes], axes) - w;
    components column[3];
    for (int j = 0; j < 3; ++j)
      column[j] = cross(angular_velocity, {inertia(0, j), inertia(1, j), inertia(2, j)});
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) change(i, j) += column[j][i] + column[i][j];
    return change;
  }

  /// The inertia torque of the link about its station.
  constexpr components inertia_moment(motion& k, const symmetric& i, int f) {
    if (i.is_zero()) return components(*m_.g);
    const components w = k.angular_velocity(f), alpha = k.angular_acceleration(f);
    return mechanics::inertia_moment(i, w, alpha, k.acceleration_matrix(f));
  }

  const skeleton& s_;
  const mechanism& m_;
  known_rates known_;
  force_system acting_;
  sequence<components>& force_ = acting_.forces();
  sequence<components>& moment_ = acting_.moments();
  sequence<expression>& share_ = acting_.shares();
};

} // namespace kanexpr::mechanics
