#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Inertias that are not constant in their bodies.
namespace kanexpr::mechanics {

namespace detail {

/// Checks rigid bodies whose inertia contains only numbers and parameters, and is therefore meant to be
/// constant, but is given along axes or about a point that may move in the body. An inertia that is meant to
/// change contains the quantities with which it changes, or the model marks it.
class inertia_checker {
public:
  /// `apart` means that a frame turns differently from its orientation, so that even the axes of a body may
  /// move in the body.
  constexpr inertia_checker(const mechanism& m, const contents& held, bool apart) : m_(m), held_(held) {
    for (int b = 0; b < m.bodies.size(); ++b)
      if (is_meant_to_stay(m.bodies[b]) && (apart || is_elsewhere(m.bodies[b]))) candidates_.push({b, {}});
  }

  constexpr base::sentence run() {
    if (candidates_.empty()) return {};
    sequence<expression> wanted;
    for (candidate& d : candidates_) d.from_center = collect_inertia(m_, m_.bodies[d.body], wanted);
    generic_motion motion(m_, held_, wanted);
    for (int state = 0, looked = 0; state < 6 && looked == 0; ++state) {
      motion.draw();
      if (!motion.move()) continue;
      ++looked; // an inertia that is constant at one generic state is constant at all
      for (const candidate& d : candidates_)
        if (changes(motion, d)) return sentence_for(m_.bodies[d.body]);
    }
    return {};
  }

private:
  struct candidate {
    int body = none;
    vector from_center{}; ///< to the reference point of the inertia
  };

  constexpr base::sentence sentence_for(const body& b) const {
    constexpr std::string_view word = "if this is intended, write changing_inertia<...>";
    const std::string_view frame = m_.frames[b.frame].called.view();
    for (const dyadic::part& p : b.inertia.parts)
      for (int axes : {p.left, p.right})
        if (axes != b.frame)
          return base::sentence({"the inertia of ", b.called.view(), " is given along the axes of ",
                                 m_.frames[axes].called.view(), " and changes as seen from ", frame,
                                 ", the body frame; ", word});
    if (b.about != none && b.about != b.center)
      return base::sentence({"the inertia of ", b.called.view(), " is given about ",
                             m_.points[b.about].called.view(), ", which moves in ", frame,
                             ", the body frame; ", word});
    return base::sentence({"the inertia of ", b.called.view(), " is not axisymmetric about the spin axis of ",
                           frame, ", whose angle is omitted; ", word});
  }

  constexpr bool is_meant_to_stay(const body& b) const {
    if (b.frame == none || b.inertia_changes || is_apart(b.frame)) return false;
    for (const dyadic::part& p : b.inertia.parts) {
      if (is_apart(p.left) || is_apart(p.right) || !held_.is_fixed(p.value)) return false;
    }
    return b.about == none || b.about == b.center || held_.is_fixed(b.mass);
  }
  /// Whether this frame, or one with which it turns, is declared to turn apart from its orientation.
  constexpr bool is_apart(int f) const {
    for (; f != mechanism::inertial; f = m_.frames[f].parent)
      if (m_.frames[f].turns_apart) return true;
    return false;
  }

  constexpr bool is_elsewhere(const body& b) const {
    for (const dyadic::part& p : b.inertia.parts)
      if (!spins_unseen(p, b.frame) && (!are_rigid(p.left, b.frame) || !are_rigid(p.right, b.frame)))
        return true;
    if (b.about == none || b.about == b.center) return false;
    for (const vector::part& p : position_from(m_, b.center, b.about).parts)
      if (!p.value.is_zero() && (!are_rigid(p.frame, b.frame) || !mechanics::is_fixed(p.value))) return true;
    return false;
  }
  /// Whether a frame only spins in the axes of an inertia, about an axis of rotational symmetry.
  constexpr bool spins_unseen(const dyadic::part& p, int f) const {
    const frame& own = m_.frames[f];
    return own.kind == orientation::about_basis && own.parent == p.left && p.left == p.right &&
           is_round(p.value, own.axis);
  }
  /// Whether two frames do not rotate relative to each other.
  constexpr bool are_rigid(int a, int b) const {
    const int meeting = path::common_ancestor(m_, a, b);
    return is_still(a, meeting) && is_still(b, meeting);
  }
  constexpr bool is_still(int f, int above) const {
    for (; f != above; f = m_.frames[f].parent) {
      const frame& own = m_.frames[f];
      if (own.has_declared_angular_velocity()) return false;
      if (own.kind == orientation::matrix ? !held_.is_fixed(own.to_parent) : !held_.is_fixed(own.angle))
        return false;
    }
    return true;
  }

  /// Whether the inertia I = Σ a⊗b has a rate in the body frame. For axes that turn with w relative to the
  /// body, İ = Σ (w_a × a)⊗b + a⊗(w_b × b).
  constexpr bool changes(const generic_motion& motion, const candidate& d) const {
    const body& b = m_.bodies[d.body];
    if (!motion.is_proper(b.frame)) return false;
    const triple own = motion.angular_velocity(b.frame);
    triad rate;
    double size = 0, turns = length(own);
    const auto add = [](triad& sum, const triad& other) {
      sum = {sum.x + other.x, sum.y + other.y, sum.z + other.z};
    };
    for (const dyadic::part& p : b.inertia.parts) {
      if (!motion.is_proper(p.left) || !motion.is_proper(p.right)) return false;
      const triple left = motion.by_orientation(p.left) - own, right = motion.by_orientation(p.right) - own;
      turns += length(left) + length(right);
      for (int i = 0; i < 3; ++i) {
        const triple a = motion.basis(p.left)[i],
                     along = motion.basis(p.right) * motion.value(p.value.row[i]);
        add(rate, outer(cross(left, a), along));
        add(rate, outer(a, cross(right, along)));
        size += length(along);
      }
    }
    triple r, moves; // position and velocity of the reference point of the inertia
    for (const vector::part& p : d.from_center.parts) {
      if (!motion.is_proper(p.frame)) return false;
      const triple part = motion.basis(p.frame) * motion.value(p.value);
      r = r + part;
      moves = moves + motion.basis(p.frame) * motion.rate(p.value) +
              cross(motion.by_orientation(p.frame) - own, part);
    }
    if (!d.from_center.parts.empty()) { // the central inertia is I − m (r·r E − r⊗r)
      const double mass = motion[b.mass].value, stretch = 2 * dot(r, moves);
      const triad spread = outer(r, moves), back = outer(moves, r);
      add(rate, {mass * (spread.x + back.x), mass * (spread.y + back.y), mass * (spread.z + back.z)});
      add(rate, {{-mass * stretch, 0, 0}, {0, -mass * stretch, 0}, {0, 0, -mass * stretch}});
      size += numeric::elementary::abs(mass) * dot(r, r);
      turns += length(r) > 0 ? length(moves) / length(r) : 0;
    }
    // the solved rates have fewer correct digits than the quantities from which they are computed
    return length(rate.x) + length(rate.y) + length(rate.z) > size * (1e-7 * turns + motion.rounding());
  }
  /// The columns of a⊗b.
  static constexpr triad outer(triple a, triple b) { return {b.x * a, b.y * a, b.z * a}; }

  const mechanism& m_;
  const contents& held_;
  sequence<candidate> candidates_{};
};

} // namespace detail

} // namespace kanexpr::mechanics
