#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The partial derivatives of the velocity of a station along a direction with respect to all speeds.
///
/// v = Σ_f w_f × S_f + relative velocities, where w_f is the relative angular velocity of each frame below
/// the station, and S_f is the part of the path from the ground to the station that rotates with it. The sum
/// is formed once, inward, and each speed needs one triple product with it. For a single point, this is
/// cheaper than the forces and moments of a unit force at the point.
class point_jacobian {
public:
  constexpr point_jacobian(const skeleton& s, int station)
      : s_(s), m_(*s.model), station_(station), carried_(m_.frames.size()) {
    for (int n = station; n != none; n = s.stations[n].absolute ? none : s.stations[n].parent)
      if (!s.stations[n].absolute) carried_[s.stations[n].frame].add(s.stations[n].offset());
    for (int f : s.frames_tips_first())
      if (s.turns_in[f] != mechanism::inertial) carried_[s.turns_in[f]].add(carried_[f]);
  }

  /// The derivatives with respect to the speeds, followed by those with respect to the auxiliary speeds.
  constexpr sequence<expression> along(const vector& direction) const {
    sequence<expression> share(m_.ways(), m_.zero());
    for (int n = station_; n != none; n = s_.stations[n].absolute ? none : s_.stations[n].parent)
      for (const partial_velocity& v : s_.partial_velocities[n])
        share[v.speed] += dot(v.value, express(m_, direction, s_.working_axes[s_.stations[n].axes]));
    for (int f = 1; f < m_.frames.size(); ++f) {
      if (s_.rigid_with[f] != f || carried_[f].parts.empty()) continue;
      for (const partial_velocity& w : s_.partial_angular_velocities[f]) {
        const seen_from best = nearest(w.value, s_.working_axes[f], direction.parts[0].frame);
        const components moved = cross(best.value, express(m_, carried_[f], best.axes));
        share[w.speed] += dot(moved, express(m_, direction, best.axes));
      }
    }
    return share;
  }

private:
  struct seen_from {
    int axes = none;
    components value;
  };

  static constexpr bool is_basis(const components& v) {
    return v.is_constant() &&
           (v.x.is_zero() ? 0 : 1) + (v.y.is_zero() ? 0 : 1) + (v.z.is_zero() ? 0 : 1) == 1;
  }

  /// Expresses an axis in the axes nearest to `goal` in which it is a basis vector, so that rotations about
  /// it cost nothing.
  constexpr seen_from nearest(const components& w, int axes, int goal) const {
    seen_from best{axes, w};
    if (!is_basis(w)) return best;
    for (int next = axes; path::common_ancestor(m_, next, goal) != next;) {
      next = m_.frames[next].parent;
      const components there = express(m_, w, axes, next);
      if (!is_basis(there)) break;
      best = {next, there};
    }
    return best;
  }

  const skeleton& s_;
  const mechanism& m_;
  int station_;
  sequence<vector> carried_; ///< S, by frame
};

} // namespace kanexpr::mechanics
