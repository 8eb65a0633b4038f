#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
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
/// that all parts rest if the kinetic energy is zero. A frame that rotates in a resting one rests as well if
/// its axes are numeric and the inertias that rotate with it resist all of its rotations. A point that slides
/// relative to a resting one rests if its directions are numeric and it has a mass. All masses and inertias
/// must be numbers for which no energy is negative.
class energy_of_motion {
public:
  constexpr explicit energy_of_motion(const skeleton& s)
      : s_(s), m_(*s.model), frame_rests_(m_.frames.size(), 0), station_rests_(s.stations.size(), 0),
        way_rests_(m_.ways(), 0) {
    frame_rests_[mechanism::inertial] = 1;
    for (int w = m_.speeds.size(); w < m_.ways(); ++w) way_rests_[w] = 1; // auxiliary speeds are zero
  }

  constexpr bool is_positive() {
    for (const link& l : s_.links)
      if (!is_never_negative(l)) return false;
    for (bool progress = true; progress;) {
      progress = false;
      for (int f = 1; f < m_.frames.size(); ++f)
        if (s_.rigid_with[f] == f && frame_rests_[f] == 0 && rests_if_frame_does_not_move(f))
          frame_rests_[f] = 1, progress = true;
      for (int n = 0; n < s_.stations.size(); ++n)
        if (station_rests_[n] == 0 && rests_if_station_does_not_move(n))
          station_rests_[n] = 1, progress = true;
    }
    for (char rests : way_rests_)
      if (rests == 0) return false;
    return true;
  }

private:
  struct ways {
    sequence<int> speeds{};
    sequence<double> values{}; ///< three numbers for each speed
    bool known = true;
  };

  static constexpr double value(const expression& e) { return e.owner().number_at(e.node()).value(); }

  static constexpr bool is_never_negative(const link& l) {
    if (!l.mass.is_constant()) return false;
    const double mass = value(l.mass.mass);
    if (!(mass >= 0) || (base::equal(mass, 0.0) && !l.mass.first_moment.is_zero())) return false;
    sequence<double> i = inertia(l, true);
    const double all = i[0] + i[4] + i[8];
    if (base::equal(all, 0.0)) return true;            // a particle
    for (int k = 0; k < 9; k += 4) i[k] += 1e-6 * all; // a rod has no inertia about its axis
    return is_positive_definite(i, 3);
  }

  /// The speeds that are not yet known to vanish.
  constexpr ways free_ways(const sequence<partial_velocity>& all, int from_axes, int to_axes) const {
    ways w;
    for (const partial_velocity& d : all) {
      if (way_rests_[d.speed] != 0) continue;
      const components c = express(m_, d.value, from_axes, to_axes);
      w.known = w.known && c.is_constant();
      if (!w.known) break;
      w.speeds.push(d.speed);
      for (int i = 0; i < 3; ++i) w.values.push(value(c[i]));
    }
    return w;
  }

  /// Whether the energy is positive definite in the speeds, so that they vanish if it is zero.
  constexpr bool settle(const ways& w, const sequence<double>& energy) {
    const int count = w.speeds.size();
    sequence<double> by_speed(count * count, 0.0);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            by_speed[i * count + j] += w.values[3 * i + k] * energy[3 * k + l] * w.values[3 * j + l];
    if (!is_positive_definite(by_speed, count)) return false;
    for (int speed : w.speeds) way_rests_[speed] = 1;
    return true;
  }

  constexpr bool rests_if_frame_does_not_move(int f) {
    if (frame_rests_[s_.turns_in[f]] == 0) return false;
    const ways w = free_ways(s_.partial_angular_velocities[f], s_.working_axes[f], s_.body_axes[f]);
    if (!w.known || w.speeds.empty()) return w.known;
    sequence<double> energy(9, 0.0);
    for (const link& l : s_.links)
      if (l.frame == f) {
        // about the station if it rests; otherwise about the mass center, where the omitted part is
        // nonnegative
        const sequence<double> own = inertia(l, station_rests_[l.station] == 0);
        for (int i = 0; i < 9; ++i) energy[i] += own[i];
      }
    return settle(w, energy);
  }

  /// The inertia about the mass center or about the station, row by row.
  static constexpr sequence<double> inertia(const link& l, bool central) {
    const double mass = value(l.mass.mass);
    const double h[]{value(l.mass.first_moment.x), value(l.mass.first_moment.y),
                     value(l.mass.first_moment.z)};
    const double square = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
    sequence<double> found;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double shift = central && mass > 0 ? ((i == j ? square : 0) - h[i] * h[j]) / mass : 0;
        found.push(value(l.mass.inertia(i, j)) - shift);
      }
    return found;
  }

  constexpr bool rests_if_station_does_not_move(int n) {
    const station& at = s_.stations[n];
    double mass = 0;
    for (const link& l : s_.links) {
      if (l.station != n) continue;
      if (frame_rests_[l.frame] != 0 || l.mass.first_moment.is_zero()) mass += value(l.mass.mass);
      if (frame_rests_[l.frame] != 0 && value(l.mass.mass) > 0) station_rests_[n] = 1;
    }
    const bool carried = !at.absolute && at.parent != none;
    if (carried && (station_rests_[at.parent] == 0 || (frame_rests_[at.frame] == 0 && !at.r.is_zero())))
      return station_rests_[n] != 0;
    const int axes = s_.working_axes[at.axes];
    const ways w = free_ways(s_.partial_velocities[n], axes, axes);
    if (!w.known || w.speeds.empty()) return w.known;
    return settle(w, {mass, 0, 0, 0, mass, 0, 0, 0, mass});
  }

  const skeleton& s_;
  const mechanism& m_;
  sequence<char> frame_rests_, station_rests_, way_rests_;
};

} // namespace kanexpr::mechanics
