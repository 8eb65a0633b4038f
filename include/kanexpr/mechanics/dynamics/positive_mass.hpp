#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Whether the lower triangle `a` belongs to a matrix that is positive definite relative to its diagonal.
constexpr bool is_positive_definite(sequence<double> a, int order) {
  const auto at = [&](int i, int j) -> double& { return a[i * order + j]; };
  for (int p = 0; p < order; ++p) {
    double left = at(p, p);
    for (int k = 0; k < p; ++k) left -= at(p, k) * at(p, k) * at(k, k);
    if (!(left > 1e-9 * at(p, p))) return false;
    at(p, p) = left;
    for (int i = p + 1; i < order; ++i) {
      for (int k = 0; k < p; ++k) at(i, p) -= at(i, k) * at(p, k) * at(k, k);
      at(i, p) /= left;
    }
  }
  return true;
}

/// Proves that a mass matrix is positive definite in every configuration by showing, from the ground outward,
/// that all parts are at rest if the kinetic energy is zero. A frame that rotates in a frame at rest is
/// itself at rest if its axes are numeric and the inertias that rotate with it resist all of its rotations;
/// the axes are numeric in the frame, or in another one if the inertias resist every rotation. A point that
/// slides relative to a point at rest is itself at rest if its directions are numeric and it has mass. All
/// masses and inertias must be numeric, and no kinetic energy may be negative.
class positive_energy_proof {
public:
  constexpr explicit positive_energy_proof(const skeleton& s)
      : s_(s), m_(*s.model), frame_is_at_rest_(m_.frames.size(), 0),
        station_is_at_rest_(s.stations.size(), 0), speed_vanishes_(m_.ways(), 0) {
    frame_is_at_rest_[mechanism::inertial] = 1;
    for (int w = m_.speeds_of_motion(); w < m_.ways(); ++w)
      speed_vanishes_[w] = 1; // auxiliary speeds are zero, and state variables have the mass 1
  }

  constexpr bool is_positive() {
    if (!s_.flexible_parts.empty()) return false; // may be singular at large amplitudes
    for (const link& l : s_.links)
      if (!is_nonnegative(l)) return false;
    for (bool progress = true; progress;) {
      progress = false;
      for (int f = 1; f < m_.frames.size(); ++f)
        if (s_.rigid_with[f] == f && frame_is_at_rest_[f] == 0 && frame_must_rest(f))
          frame_is_at_rest_[f] = 1, progress = true;
      for (int n = 0; n < s_.stations.size(); ++n)
        if (station_is_at_rest_[n] == 0 && station_must_rest(n)) station_is_at_rest_[n] = 1, progress = true;
    }
    for (char rests : speed_vanishes_)
      if (rests == 0) return false;
    return true;
  }

private:
  /// Numeric partial velocities.
  struct numeric_partials {
    sequence<int> speeds{};
    sequence<triple> values{};
    bool known = true;

    constexpr void add(int speed, const triple& value) {
      for (int i = 0; i < speeds.size(); ++i)
        if (speeds[i] == speed) {
          values[i] = values[i] + value;
          return;
        }
      speeds.push(speed);
      values.push(value);
    }
  };

  static constexpr double value(const expression& e) { return e.owner().number_at(e.node()).value(); }
  static constexpr triple value(const components& v) { return {value(v.x), value(v.y), value(v.z)}; }

  static constexpr bool is_nonnegative(const link& l) {
    if (!l.mass.is_constant()) return false;
    const double mass = value(l.mass.mass);
    if (!(mass >= 0) || (base::equal(mass, 0.0) && !l.mass.first_moment.is_zero())) return false;
    const triad i = inertia(l, true);
    const double all = i.x.x + i.y.y + i.z.z;
    if (base::equal(all, 0.0)) return true;                // a particle
    return is_positive_definite(i + diagonal(1e-6 * all)); // a rod has no inertia about its axis
  }
  static constexpr bool is_positive_definite(const triad& a) {
    return mechanics::is_positive_definite({a.x.x, a.y.x, a.z.x, a.x.y, a.y.y, a.z.y, a.x.z, a.y.z, a.z.z},
                                           3);
  }

  /// The speeds that are not yet known to vanish.
  constexpr numeric_partials free_speeds(const sequence<partial_velocity>& all, int from_axes,
                                         int to_axes) const {
    numeric_partials w;
    for (const partial_velocity& d : all) {
      if (speed_vanishes_[d.speed] != 0) continue;
      const components c = express(m_, d.value, from_axes, to_axes);
      w.known = w.known && c.is_constant();
      if (!w.known) break;
      w.add(d.speed, value(c));
    }
    return w;
  }

  /// Whether the energy is positive definite in the speeds; if so, records that they vanish.
  constexpr bool prove(const numeric_partials& w, const triad& energy) {
    const int count = w.speeds.size();
    sequence<double> by_speed;
    for (const triple& one : w.values)
      for (const triple& other : w.values) by_speed.push(dot(one, energy * other));
    if (!mechanics::is_positive_definite(by_speed, count)) return false;
    for (int speed : w.speeds) speed_vanishes_[speed] = 1;
    return true;
  }

  /// The partial angular velocities of a frame in the innermost one around it that is at rest.
  constexpr numeric_partials free_rotations(int f, int axes) const {
    numeric_partials all;
    for (int g = f; all.known && frame_is_at_rest_[g] == 0; g = s_.turns_in[g]) {
      const numeric_partials some = free_speeds(s_.partial_angular_velocities[g], s_.working_axes[g], axes);
      all.known = some.known;
      for (int i = 0; i < some.speeds.size(); ++i) all.add(some.speeds[i], some.values[i]);
    }
    return all;
  }

  constexpr bool frame_must_rest(int f) {
    const numeric_partials w = free_rotations(f, s_.body_axes[f]);
    if (w.known && w.speeds.empty()) return true;
    triad energy;
    for (const link& l :
         s_.links)      // about the station if it is at rest; otherwise about the mass center, where the
      if (l.frame == f) // omitted part is nonnegative
        energy = energy + inertia(l, station_is_at_rest_[l.station] == 0);
    if (w.known) return prove(w, energy);
    if (!is_positive_definite(energy)) return false;
    // The inertias resist every rotation, so it suffices that the rotations are independent, in any axes.
    for (int axes = f; axes != mechanism::inertial; axes = m_.frames[axes].parent) {
      const numeric_partials v = free_rotations(f, axes);
      if (v.known) return prove(v, diagonal(1));
    }
    return false;
  }

  /// The inertia about the mass center or about the station.
  static constexpr triad inertia(const link& l, bool central) {
    const double mass = value(l.mass.mass);
    const triple h = value(l.mass.first_moment);
    triad found;
    for (int i = 0; i < 9; ++i) found[i / 3][i % 3] = value(l.mass.inertia(i / 3, i % 3));
    if (!central || !(mass > 0)) return found;
    const triple r{h.x / mass, h.y / mass, h.z / mass};
    return found + outer(r, h) + diagonal(-dot(r, h));
  }

  constexpr bool station_must_rest(int n) {
    const station& at = s_.stations[n];
    double mass = 0;
    for (const link& l : s_.links) {
      if (l.station != n) continue;
      if (frame_is_at_rest_[l.frame] != 0 || l.mass.first_moment.is_zero()) mass += value(l.mass.mass);
      if (frame_is_at_rest_[l.frame] != 0 && value(l.mass.mass) > 0) station_is_at_rest_[n] = 1;
    }
    const bool carried = !at.absolute && at.parent != none;
    if (carried &&
        (station_is_at_rest_[at.parent] == 0 || (frame_is_at_rest_[at.frame] == 0 && !at.r.is_zero())))
      return station_is_at_rest_[n] != 0;
    const int axes = s_.working_axes[at.axes];
    const numeric_partials w = free_speeds(s_.partial_velocities[n], axes, axes);
    if (!w.known || w.speeds.empty()) return w.known;
    return prove(w, diagonal(mass));
  }

  const skeleton& s_;
  const mechanism& m_;
  sequence<char> frame_is_at_rest_, station_is_at_rest_, speed_vanishes_;
};

} // namespace kanexpr::mechanics
