#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// Combines masses that move as one body, and regroups them into the smallest set of parameters that
/// determines the motion.
namespace kanexpr::mechanics {

namespace detail {

/// The links being gathered: at most one for each station and frame.
class mass_regrouping {
public:
  constexpr mass_regrouping(const skeleton& s, const sequence<link>& links) : s_(s), at_(s.stations.size()) {
    for (const link& l : links) put(l);
  }

  /// Proceeds from the tips to the ground; `regroup` specifies whether mass properties may move across
  /// joints.
  constexpr sequence<link> run(bool regroup) {
    for (int c = s_.stations.size() - 1; c >= 0; --c)
      for (int i = deepest_at(c); i >= 0; i = deepest_at(c)) {
        const link l = at_[c][i];
        at_[c][i].station = none;
        const station& at = s_.stations[c];
        if (l.frame == at.frame && at.rigid && !at.absolute && !is_about_its_center(l.frame))
          put({at.parent, l.frame, shifted(l.mass, at.r)});
        else if (regroup)
          settled_.push(without_unobservable_part(l));
        else
          settled_.push(l);
      }
    return settled_;
  }

private:
  /// Whether the formulation of the model keeps the masses of a frame at their centers.
  constexpr bool is_about_its_center(int f) const {
    for (const formulation_of_frame& given : s_.model->formulated.frames)
      if (given.about_the_center && s_.rigid_with[given.frame] == f) return true;
    return false;
  }

  constexpr void put(const link& added) {
    for (link& l : at_[added.station])
      if (l.station != none && l.frame == added.frame) {
        l.mass += added.mass;
        return;
      }
    at_[added.station].push(added);
  }

  /// The remaining link at station `c` whose frame is the farthest from the ground, or -1.
  constexpr int deepest_at(int c) const {
    int found = -1, depth = -1;
    const link* const links = at_[c].begin();
    for (int i = 0, end = at_[c].size(); i < end; ++i) {
      if (links[i].station == none) continue;
      const int d = path::depth(*s_.model, links[i].frame);
      if (d > depth) found = i, depth = d;
    }
    return found;
  }

  /// Moves the part of a link whose motion relative to the frame below has no effect. If the station is fixed
  /// in the frame below, or that frame also has mass there, the mass acts on that frame as a particle at the
  /// station. Likewise, a joint about axis a does not sense the part {m, h_a, I_dd about both other axes} of
  /// the link it carries (base inertial parameters: Gautier & Khalil 1990). Numeric values are folded into
  /// the frame below. If the values are symbolic, only the mass is moved, which never costs more than it
  /// saves.
  constexpr link without_unobservable_part(const link& l) {
    const station& at = s_.stations[l.station];
    const bool is_at_rest = at.rigid || (at.absolute && at.relative_velocity.parts.empty());
    const int below = l.frame == at.frame ? s_.turns_in[l.frame] : at.frame;
    if (l.frame == at.frame ? !carries(l.station, below) : !is_at_rest) return l;
    const mechanism& m = *s_.model;
    rigid_mass moved(*m.g);
    link left = l;
    moved.mass = l.mass.mass;
    left.mass.mass = m.zero();

    const int a = s_.joint_axis(l.frame);
    if (a != none && l.mass.is_constant() && s_.body_axes[l.frame] == l.frame &&
        s_.turns_in[l.frame] == at.frame) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      components along(*m.g);
      along[a] = l.mass.first_moment[a];
      moved.inertia(b, b) = moved.inertia(d, d) = l.mass.inertia(d, d);
      const path to_below(m, m.frames[l.frame].parent, s_.body_axes[at.frame]);
      moved.first_moment = to_below.turn(along);
      moved.inertia = to_below.turn(moved.inertia);
      left.mass.first_moment[a] = m.zero();
      left.mass.inertia(b, b) -= l.mass.inertia(d, d);
      left.mass.inertia(d, d) = m.zero();
    }
    const int spin = spin_axis(l.frame, below);
    if (spin != none && is_round(l.mass.inertia, spin)) {
      symmetric across = l.mass.inertia; // the spinning body keeps only its inertia about the axis
      across(spin, spin) = m.zero();
      left.mass.inertia = symmetric(*m.g);
      left.mass.inertia(spin, spin) = l.mass.inertia(spin, spin);
      moved.inertia = path(m, s_.body_axes[l.frame], s_.body_axes[below]).turn(across);
    }
    put({l.station, below, moved});
    return left;
  }

  /// Whether a mass at the station moves with `frame` and the frame is not the ground.
  constexpr bool carries(int station, int frame) const {
    for (const link& l : at_[station])
      if (l.station != none && l.frame == frame) return frame != mechanism::inertial;
    return false;
  }

  /// The axis about which frame `f` spins in the frame below, in non-spinning axes; none if its motion is not
  /// a spin.
  constexpr int spin_axis(int f, int below) const {
    if (s_.turns_in[f] != below || s_.rigid_with[s_.body_axes[f]] != below) return none;
    const components w = express(*s_.model, s_.relative_angular_velocity[f], s_.body_axes[f]);
    for (int a = 0; a < 3; ++a)
      if (w[(a + 1) % 3].is_zero() && w[(a + 2) % 3].is_zero()) return a;
    return none;
  }

  const skeleton& s_;
  sequence<sequence<link>> at_; ///< by station; those that have been taken away have none
  sequence<link> settled_{};
};

} // namespace detail

constexpr void gather_masses(skeleton& s) {
  s.base_links = detail::mass_regrouping(s, s.links).run(true);
  s.links = detail::mass_regrouping(s, s.links).run(false);
}

} // namespace kanexpr::mechanics
