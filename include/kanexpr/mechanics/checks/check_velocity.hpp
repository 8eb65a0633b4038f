#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/involved_speeds.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

/// Compares declared velocities, and points fixed in frames, with the rates of positions.
namespace kanexpr::mechanics {

namespace detail {

/// Compares velocities at several random states, so that both sides of min, max and similar functions are
/// covered, and with one speed at a time, so that no speed is lost in the rounding errors of others.
///
/// A declared velocity is accepted if it equals the rate of the position from the origin, or the velocity of
/// its reference or parent plus the rate of the offset from there. If the angular velocity of a frame
/// contains the rate of an angle that its orientation omits, both angular velocities are tried. For a point
/// without an offset, there is no position to compare with. Speeds that appear in no kinematic equation are
/// the rates of coordinates that the model omits.
class velocity_checker {
public:
  constexpr velocity_checker(const mechanism& m, const contents& held)
      : m_(m), held_(held), motion_(m, held, geometry_of(m)) {}

  constexpr base::sentence run() {
    base::sentence found;
    for (int state = 0; state < 4 && !found && motion_.find_state(false); ++state) {
      found = mistaken_velocity();
      for (int i = 0; i < m_.bodies.size() && !found; ++i) found = deviating_mass(m_.bodies[i].center);
      for (int i = 0; i < m_.flexible_bodies.size() && !found; ++i)
        found = deviating_mass(m_.flexible_bodies[i].reference);
    }
    if (found) return found;
    const sequence<int> involved = speeds_of_declared_velocities();
    for (int i = 0; i < m_.speeds.size() && !found; ++i) {
      if (!involved.contains(m_.speeds[i].node())) continue;
      motion_.draw();
      motion_.keep_only(m_.speeds[i]);
      if (motion_.move(false)) found = mistaken_velocity();
    }
    return found;
  }

  /// Whether a velocity is declared for a point with index `first` or higher.
  static constexpr bool is_any_declared(const mechanism& m, int first) {
    for (int p = first; p < m.points.size(); ++p)
      if (m.points[p].has_declared_velocity()) return true;
    return false;
  }
  /// Whether the velocity of a mass may differ from the rate of its position.
  static constexpr bool may_any_deviate(const mechanism& m, const contents& held) {
    const auto may = [&](int point) {
      for (int p = point; p != none; p = m.points[p].parent)
        if (may_deviate(m, held, m.points[p])) return true;
      return false;
    };
    for (const body& b : m.bodies)
      if (may(b.center)) return true;
    for (const flexible_body& b : m.flexible_bodies)
      if (may(b.reference)) return true;
    return false;
  }

private:
  constexpr sequence<int> speeds_of_declared_velocities() const {
    involved_speeds found(m_, held_);
    for (int p = 0; p < m_.points.size(); ++p)
      if (is_to_agree(m_.points[p])) found.add_point(p);
    return found.all();
  }

  constexpr base::sentence mistaken_velocity() const {
    for (int p = 0; p < m_.points.size(); ++p)
      if (is_to_agree(m_.points[p]) && is_defined(p) && !agrees(p))
        return base::sentence(
            {"the velocity of point ", m_.points[p].called.view(),
             " is not the rate of its position; if this is intended, write velocity_apart_from_position"});
    return {};
  }

  constexpr base::sentence deviating_mass(int point) const {
    const int p = deviating_point(point);
    if (p == none) return {};
    return base::sentence(
        {"point ", m_.points[p].called.view(), " is fixed in ",
         m_.frames[m_.points[p].fixed_in].called.view(), ", but its offset from ",
         m_.points[m_.points[p].parent].called.view(),
         " changes in that frame; if this is intended, write velocity_apart_from_position"});
  }

  /// Whether the velocity of a point may differ from the rate of its position; a symbolic test that excludes
  /// most points.
  static constexpr bool may_deviate(const mechanism& m, const contents& held, const point& p) {
    bool is_seen_fixed = true;
    for (const vector::part& part : p.offset.parts)
      is_seen_fixed = is_seen_fixed && part.frame == p.fixed_in && held.is_fixed(part.value);
    return p.fixed_in != none && !is_seen_fixed &&
           !(m.points[p.parent].parent == none && is_placed_by_frame(m, held, p));
  }

  /// Whether the offset of a point contains only variables that also orient the frame in which it is fixed.
  static constexpr bool is_placed_by_frame(const mechanism& m, const contents& held, const point& p) {
    sequence<int> of_place, of_frame;
    for (const vector::part& part : p.offset.parts) {
      for (int i = 0; i < 3; ++i) collect_moving(held, part.value[i], of_place);
      collect_orientation(m, held, part.frame, of_place);
    }
    collect_orientation(m, held, p.fixed_in, of_frame);
    return of_frame.contains_all(of_place);
  }
  static constexpr void collect_orientation(const mechanism& m, const contents& held, int frame,
                                            sequence<int>& symbols) {
    for (int f = frame; f != none; f = m.frames[f].parent)
      for (const expression& e : m.frames[f].scalars()) collect_moving(held, e, symbols);
  }
  static constexpr void collect_moving(const contents& held, expression e, sequence<int>& symbols) {
    using kind = symbolic::symbol_kind;
    for (kind k : {kind::coordinate, kind::input, kind::time}) held.collect(e, k, symbols);
  }

  using angular_velocities = generic_motion::angular_velocities;
  static constexpr angular_velocities by_orientation = &generic_motion::by_orientation,
                                      as_used = &generic_motion::angular_velocity;

  static constexpr sequence<expression> geometry_of(const mechanism& m) {
    sequence<expression> all;
    for (const point& p : m.points) push_entries(all, p.offset), push_entries(all, p.velocity);
    return all;
  }

  constexpr bool is_to_agree(const point& p) const {
    if (!p.has_declared_velocity() || p.moves_apart || p.offset.is_zero()) return false;
    for (const vector* v : {&p.offset, &p.velocity})
      for (const vector::part& part : v->parts)
        if (!motion_.is_proper(part.frame)) return false;
    return motion_.is_proper(p.reference);
  }

  constexpr bool is_defined(int place) const {
    for (int p = place; p != none; p = m_.points[p].parent)
      if (!motion_.is_defined(m_.points[p].offset) || !motion_.is_defined(m_.points[p].velocity))
        return false;
    return true;
  }

  constexpr bool agrees(int place) const {
    const point& p = m_.points[place];
    const triple declared = motion_.vector_of(p.velocity);
    for (const angular_velocities w : {by_orientation, as_used}) {
      const triple rate = motion_.rate_of(p.offset, w);
      if (p.from_parent ? is_same(declared + carried(p, w), rate, reach(p))
                        : is_same(declared, velocity(p.parent) + rate, reach_from_origin(place)))
        return true;
    }
    return !p.from_parent &&
           is_same(declared, rate_from_origin(place, by_orientation), reach_from_origin(place));
  }

  /// Returns the first point, on the path to a mass, whose velocity differs from the rate of its position
  /// although the velocity of its parent does not.
  constexpr int deviating_point(int center) const {
    bool may = false;
    for (int p = center; p != none && !may; p = m_.points[p].parent)
      may = may_deviate(m_, held_, m_.points[p]);
    if (!may || !is_defined(center) || follows_position(center)) return none;
    int found = none, next = none;
    for (int p = center; p != none; next = p, p = m_.points[p].parent)
      if (deviates(p) && follows_position(m_.points[p].parent) && !is_contact(p, next) && !rolls(p))
        found = p;
    return found;
  }

  /// Whether the velocity that a frame gives to a point fixed in it differs from the rate of the offset.
  constexpr bool deviates(int place) const {
    const point& p = m_.points[place];
    if (p.fixed_in == none || !motion_.is_proper(p.fixed_in)) return false;
    for (const vector::part& part : p.offset.parts)
      if (!motion_.is_proper(part.frame)) return false;
    for (const angular_velocities w : {by_orientation, as_used})
      if (is_same(in_frame(p), motion_.rate_of(p.offset, w), reach(p))) return false;
    return true;
  }

  /// Whether two bodies touch at a massless point: for both of them, the velocity of the point differs from
  /// the rate of its offset.
  constexpr bool is_contact(int place, int next) const {
    for (const body& b : m_.bodies)
      if (b.center == place) return false;
    return next != none && deviates(next);
  }

  /// Whether a point belongs to a body that rolls on the ground and whose position is omitted because the
  /// rest of its motion determines it.
  constexpr bool rolls(int place) const {
    const point& p = m_.points[place];
    return is_same(velocity(p.parent), {}, reach_from_origin(p.parent)) && is_placed_by_frame(m_, held_, p);
  }

  constexpr bool follows_position(int place) const {
    for (const angular_velocities w : {by_orientation, as_used}) {
      const difference apart = velocity_deviation(place, w);
      if (length(apart.value) <= 1e-9 * apart.size + rounding(apart.reach)) return true;
    }
    return false;
  }

  /// The difference between a velocity and the rate of a position; terms common to both do not contribute to
  /// its scale.
  struct difference {
    triple value{};
    double size = 0, reach = 0;

    constexpr void add(triple a, triple b, double more_reach) {
      value = value + (a - b), size += length(a) + length(b), reach += more_reach;
    }
  };

  constexpr difference velocity_deviation(int place, angular_velocities w) const {
    const point& p = m_.points[place];
    difference sum;
    if (p.parent == none) return sum;
    if (p.has_declared_velocity() && !p.from_parent && p.fixed_in == none) {
      sum.add(motion_.vector_of(p.velocity), rate_from_origin(place, w), reach_from_origin(place));
      return sum;
    }
    sum = velocity_deviation(p.parent, w);
    if (p.fixed_in != none)
      sum.add(in_frame(p), motion_.rate_of(p.offset, w), reach(p));
    else if (p.has_declared_velocity())
      sum.add(motion_.vector_of(p.velocity) + carried(p, as_used), motion_.rate_of(p.offset, w), reach(p));
    else
      for (const vector::part& part : p.offset.parts) {
        const triple there = motion_.basis(part.frame) * motion_.value(part.value);
        sum.add(cross(motion_.angular_velocity(part.frame) - (motion_.*w)(part.frame), there), {},
                length(there));
      }
    return sum;
  }

  constexpr bool is_same(triple a, triple b, double reach) const {
    return length(a - b) <= 1e-9 * (length(a) + length(b)) + rounding(reach);
  }
  constexpr double rounding(double reach) const { return motion_.rounding() * (1 + reach); }

  constexpr double reach(const point& p) const {
    double sum = 0;
    for (const vector::part& part : p.offset.parts) sum += length(motion_.value(part.value));
    return sum;
  }
  constexpr double reach_from_origin(int place) const {
    double sum = 0;
    for (int p = place; p != none; p = m_.points[p].parent) sum += reach(m_.points[p]);
    return sum;
  }

  /// The velocity due to the rotation of the reference.
  constexpr triple carried(const point& p, angular_velocities w) const {
    return cross((motion_.*w)(p.reference), motion_.vector_of(p.offset));
  }

  /// The velocity relative to the parent.
  constexpr triple in_frame(const point& p) const {
    return cross(motion_.angular_velocity(p.fixed_in), motion_.vector_of(p.offset));
  }

  constexpr triple rate_from_origin(int place, angular_velocities w) const {
    triple sum;
    for (int p = place; p != none; p = m_.points[p].parent)
      sum = sum + motion_.rate_of(m_.points[p].offset, w);
    return sum;
  }

  /// The velocity used in the equations of motion.
  constexpr triple velocity(int place) const {
    const point& p = m_.points[place];
    if (p.parent == none) return {};
    if (p.fixed_in != none) return velocity(p.parent) + in_frame(p);
    if (!p.has_declared_velocity()) return velocity(p.parent) + motion_.rate_of(p.offset, as_used);
    const triple declared = motion_.vector_of(p.velocity);
    return p.from_parent ? velocity(p.parent) + carried(p, as_used) + declared : declared;
  }

  const mechanism& m_;
  const contents& held_;
  generic_motion motion_;
};

} // namespace detail

} // namespace kanexpr::mechanics
