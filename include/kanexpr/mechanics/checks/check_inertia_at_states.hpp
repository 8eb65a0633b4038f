#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Checks inertias that are given along the axes of several frames, or that contain symbols, by evaluating
/// them at generic states.
namespace kanexpr::mechanics {

namespace detail {

/// A rigid body whose inertia is evaluated.
struct evaluated_inertia {
  int body = none;
  vector from_center{};     ///< from the mass center to the reference point of the inertia
  numeric_inertia before{}; ///< the inertia at the first state
  numeric_offset offset_before{};
};

/// Evaluates the inertias of some bodies at generic states.
class inertias_at_states {
public:
  constexpr inertias_at_states(const mechanism& m, const contents& held) : m_(m), held_(held) {}

protected:
  /// Calls `test(motion, inertia, state)` at one or more generic states and returns the first mistake that it
  /// reports.
  template <class Test>
  constexpr base::sentence first_mistake(int states, const Test& test) {
    if (bodies_.empty()) return {};
    sequence<expression> wanted;
    for (evaluated_inertia& each : bodies_) collect(each, wanted);
    generic_motion motion(m_, held_, wanted);
    for (int state = 0; state < states && motion.find_state(); ++state)
      for (evaluated_inertia& each : bodies_)
        if (is_proper(motion, each))
          if (const base::sentence found = test(motion, each, state)) return found;
    return {};
  }

  const mechanism& m_;
  const contents& held_;
  sequence<evaluated_inertia> bodies_{};

private:
  constexpr void collect(evaluated_inertia& of, sequence<expression>& wanted) const {
    const body& b = m_.bodies[of.body];
    if (b.is_off_center()) of.from_center = position_from(m_, b.center, b.about);
    wanted.push(b.mass);
    b.inertia.each_entry([&](expression e) { wanted.push(e); });
    push_entries(wanted, of.from_center);
  }

  constexpr bool is_proper(const generic_motion& motion, const evaluated_inertia& of) const {
    const body& b = m_.bodies[of.body];
    bool proper = motion.is_proper(b.frame);
    for (const dyadic::part& p : b.inertia.parts)
      proper = proper && motion.is_proper(p.left) && motion.is_proper(p.right);
    for (const vector::part& p : of.from_center.parts) proper = proper && motion.is_proper(p.frame);
    return proper;
  }
};

/// Checks rigid bodies whose inertia contains only numbers and parameters, and is therefore meant to be
/// constant, but is given along axes or about a point that may move in the body. An inertia that is meant to
/// change contains the quantities with which it changes, or is marked in the model.
class changing_inertia_checker : public inertias_at_states {
public:
  /// `apart` means that some frame turns differently from its orientation, so that even a body's own axes may
  /// move in the body.
  constexpr changing_inertia_checker(const mechanism& m, const contents& held, bool apart)
      : inertias_at_states(m, held) {
    for (int b = 0; b < m.bodies.size(); ++b)
      if (should_be_constant(m.bodies[b]) && (apart || may_vary(m.bodies[b]))) bodies_.push({.body = b});
  }

  constexpr base::sentence run() {
    // an inertia that is constant at one generic state is constant at all
    return first_mistake(1, [&](const generic_motion& motion, const evaluated_inertia& each, int) {
      return changes(motion, each) ? sentence_for(m_.bodies[each.body]) : base::sentence();
    });
  }

private:
  constexpr base::sentence sentence_for(const body& b) const {
    constexpr const char* word = "if this is intended, write changing_inertia<...>";
    const std::string_view frame = m_.frames[b.frame].called.view();
    for (const dyadic::part& p : b.inertia.parts)
      for (int axes : {p.left, p.right})
        if (axes != b.frame)
          return base::sentence({"the inertia of ", b.called.view(), " is given along the axes of ",
                                 m_.frames[axes].called.view(), " and changes as seen from ", frame,
                                 ", the body frame; ", word});
    if (b.is_off_center())
      return base::sentence({"the inertia of ", b.called.view(), " is given about ",
                             m_.points[b.about].called.view(), ", which moves in ", frame,
                             ", the body frame; ", word});
    return base::sentence({"the inertia of ", b.called.view(), " is not axisymmetric about the spin axis of ",
                           frame, ", whose angle is omitted; ", word});
  }

  constexpr bool should_be_constant(const body& b) const {
    if (b.frame == none || b.inertia_changes || is_apart(b.frame)) return false;
    for (const dyadic::part& p : b.inertia.parts)
      if (is_apart(p.left) || is_apart(p.right) || !held_.is_fixed(p.value)) return false;
    return !b.is_off_center() || held_.is_fixed(b.mass);
  }
  /// Whether this frame, or one relative to which it is oriented, has an angular velocity that is declared
  /// separately from its orientation.
  constexpr bool is_apart(int f) const {
    for (; f != mechanism::inertial; f = m_.frames[f].parent)
      if (m_.frames[f].turns_apart) return true;
    return false;
  }

  constexpr bool may_vary(const body& b) const {
    for (const dyadic::part& p : b.inertia.parts)
      if (!spins_about_symmetry_axis(p, b.frame) &&
          (!are_rigid(p.left, b.frame) || !are_rigid(p.right, b.frame)))
        return true;
    if (!b.is_off_center()) return false;
    for (const vector::part& p : position_from(m_, b.center, b.about).parts)
      if (!p.value.is_zero() && (!are_rigid(p.frame, b.frame) || !mechanics::is_fixed(p.value))) return true;
    return false;
  }
  /// Whether a frame only spins in the axes of an inertia, about an axis of rotational symmetry.
  constexpr bool spins_about_symmetry_axis(const dyadic::part& p, int f) const {
    const frame& own = m_.frames[f];
    return own.kind == orientation::about_basis && own.parent == p.left && p.left == p.right &&
           is_round(p.value, own.axis);
  }
  /// Whether two frames do not rotate relative to each other.
  constexpr bool are_rigid(int a, int b) const {
    const int meeting = path::common_ancestor(m_, a, b);
    return is_at_rest_in(a, meeting) && is_at_rest_in(b, meeting);
  }
  constexpr bool is_at_rest_in(int f, int above) const {
    for (; f != above; f = m_.frames[f].parent)
      if (m_.frames[f].has_declared_angular_velocity() || !held_.is_fixed(m_.frames[f])) return false;
    return true;
  }

  /// Whether the inertia I = Σ a⊗b has a rate in the body frame. For axes that turn with w relative to the
  /// body, İ = Σ (w_a × a)⊗b + a⊗(w_b × b).
  constexpr bool changes(const generic_motion& motion, const evaluated_inertia& each) const {
    const body& b = m_.bodies[each.body];
    const triple own = motion.angular_velocity(b.frame);
    triad rate;
    double size = 0, turns = length(own);
    for (const dyadic::part& p : b.inertia.parts) {
      const triple left = motion.by_orientation(p.left) - own, right = motion.by_orientation(p.right) - own;
      turns += length(left) + length(right);
      for (int i = 0; i < 3; ++i) {
        const triple a = motion.basis(p.left)[i],
                     along = motion.basis(p.right) * motion.value(p.value.row[i]);
        rate = rate + outer(cross(left, a), along) + outer(a, cross(right, along));
        size += length(along);
      }
    }
    triple r, moves; // position and velocity of the reference point of the inertia
    for (const vector::part& p : each.from_center.parts) {
      const triple part = motion.basis(p.frame) * motion.value(p.value);
      r = r + part;
      moves = moves + motion.basis(p.frame) * motion.rate(p.value) +
              cross(motion.by_orientation(p.frame) - own, part);
    }
    if (!each.from_center.parts.empty()) { // the central inertia is I − m (r·r E − r⊗r)
      const double mass = motion[b.mass].value;
      rate = rate + mass * (outer(r, moves) + outer(moves, r)) + diagonal(-mass * 2 * dot(r, moves));
      size += numeric::elementary::abs(mass) * dot(r, r);
      turns += length(r) > 0 ? length(moves) / length(r) : 0;
    }
    // the solved rates have fewer correct digits than the quantities from which they are computed
    return length(rate.x) + length(rate.y) + length(rate.z) > size * (1e-7 * turns + motion.rounding());
  }
};

/// Finds physically impossible inertias that are sums over the axes of several frames, or that contain
/// symbols. An inertia that has the same value at two states is treated as numeric.
class dyadics_checker : public inertias_at_states {
public:
  constexpr dyadics_checker(const mechanism& m, const contents& held) : inertias_at_states(m, held) {
    for (int b = 0; b < m.bodies.size(); ++b)
      if (needs_check(m.bodies[b].inertia)) bodies_.push({.body = b});
  }

  constexpr base::sentence run() {
    return first_mistake(2, [&](const generic_motion& motion, evaluated_inertia& each, int state) {
      return evaluate(motion, each, state == 0);
    });
  }

private:
  static constexpr bool needs_check(const dyadic& inertia) {
    if (inertia.parts.empty()) return false;
    if (!inertia.is_in_one_frame()) return true;
    const matrix3& value = inertia.parts[0].value;
    for (int i = 0; i < 3; ++i)
      if (value(i, (i + 1) % 3) != value((i + 1) % 3, i)) return true;
    return false;
  }

  constexpr base::sentence evaluate(const generic_motion& motion, evaluated_inertia& each,
                                    bool is_first) const {
    const body& b = m_.bodies[each.body];
    const numeric_inertia inertia = inertia_in_body(motion, b);
    const double largest = inertia.largest();
    if (!(largest > 1e-100) || !(largest < 1e100)) return {};
    numeric_inertia scaled = inertia;
    scaled.scale(1 / largest);
    if (!scaled.is_symmetric(1e-9))
      return base::sentence({"the inertia of ", b.called.view(), " is not symmetric"});
    numeric_offset offset = offset_in_body(motion, each);
    if (!is_first && !b.effective && is_same(inertia, each.before, largest)) {
      offset.known = offset.known && is_same(offset, each.offset_before);
      return check_principal_values(m_, b, scaled, largest, offset);
    }
    each.before = inertia;
    each.offset_before = offset;
    return {};
  }

  static constexpr numeric_inertia inertia_in_body(const generic_motion& motion, const body& b) {
    const triad& own = motion.basis(b.frame);
    numeric_inertia sum;
    for (const dyadic::part& p : b.inertia.parts)
      for (int k = 0; k < 3; ++k)
        sum.at = sum.at + outer(own.along(motion.basis(p.left)[k]),
                                own.along(motion.basis(p.right) * motion.value(p.value.row[k])));
    return sum;
  }

  constexpr numeric_offset offset_in_body(const generic_motion& motion, const evaluated_inertia& each) const {
    numeric_offset offset;
    if (each.from_center.parts.empty()) return offset;
    const body& b = m_.bodies[each.body];
    offset.r = motion.basis(b.frame).along(motion.vector_of(each.from_center));
    offset.mass = motion[b.mass].value;
    offset.known = offset.mass < 1e30 && dot(offset.r, offset.r) < 1e60;
    return offset;
  }

  static constexpr bool is_same(const numeric_inertia& a, const numeric_inertia& b, double largest) {
    for (int i = 0; i < 9; ++i)
      if (!(numeric::elementary::abs(a.at[i / 3][i % 3] - b.at[i / 3][i % 3]) < 1e-9 * largest)) return false;
    return true;
  }
  static constexpr bool is_same(const numeric_offset& a, const numeric_offset& b) {
    return numeric::elementary::abs(a.mass - b.mass) < 1e-9 * a.mass &&
           length(a.r - b.r) < 1e-9 * length(a.r);
  }
};

} // namespace detail

} // namespace kanexpr::mechanics
