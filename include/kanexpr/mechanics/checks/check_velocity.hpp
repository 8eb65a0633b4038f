#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>

/// Velocities that are declared, against the rates of positions.
namespace kanexpr::mechanics {

namespace detail {

/// An equality that holds at one generic state holds at all.
///
/// A declared velocity agrees if it is the rate of the position from the origin, or what its reference or its
/// parent moves with and the rate of the offset from there. A frame whose angular velocity holds an angle
/// that its orientation leaves out turns with that angle or without. A point without any offset has no
/// position to compare with, and speeds in no kinematic equation are the rates of coordinates that the model
/// leaves out.
class checking_velocity {
public:
  constexpr checking_velocity(const mechanism& m, const contents& held)
      : m_(m), motion_(m, held, geometry_of(m)) {}

  constexpr sentence run() {
    if (!draw()) return {};
    for (int p = 0; p < m_.points.size(); ++p)
      if (is_to_agree(m_.points[p]) && !agrees(p))
        return sentence({"the velocity of point ", m_.points[p].called.view(),
                         " is not the rate of its position; if that is meant, write "
                         "velocity_apart_from_position"});
    return {};
  }

private:
  using angular_velocities = triple (generic_motion::*)(int) const;
  static constexpr angular_velocities by_orientation = &generic_motion::by_orientation,
                                      as_used = &generic_motion::angular_velocity;

  static constexpr sequence<expression> geometry_of(const mechanism& m) {
    sequence<expression> all;
    for (const point& p : m.points)
      for (const vector* v : {&p.offset, &p.velocity})
        for (const vector::part& part : v->parts)
          for (int i = 0; i < 3; ++i) all.push(part.value[i]);
    return all;
  }

  constexpr bool draw() {
    for (int tries = 0; tries < 6; ++tries) {
      motion_.draw();
      if (motion_.move(false)) return true;
    }
    return false;
  }

  constexpr bool is_to_agree(const point& p) const {
    if (!p.moves_by_declaration() || p.moves_apart || p.offset.is_zero()) return false;
    for (const vector* v : {&p.offset, &p.velocity})
      for (const vector::part& part : v->parts)
        if (!motion_.is_proper(part.frame)) return false;
    return motion_.is_proper(p.reference);
  }

  constexpr bool agrees(int place) const {
    const point& p = m_.points[place];
    const triple said = motion_.vector_of(p.velocity);
    for (const angular_velocities w : {by_orientation, as_used}) {
      const triple rate = rate_of(p.offset, w);
      if (p.from_parent ? is_same(said + carried(p, w), rate) : is_same(said, velocity(p.parent) + rate))
        return true;
    }
    return !p.from_parent && is_same(said, rate_from_origin(place));
  }

  constexpr bool is_same(triple a, triple b) const {
    return length(a - b) <= 1e-9 * (length(a) + length(b)) + motion_.rounding();
  }

  constexpr triple rate_of(const vector& v, angular_velocities w) const {
    triple sum;
    for (const vector::part& p : v.parts) {
      const triad& axes = motion_.basis(p.frame);
      sum = sum + axes * motion_.rate(p.value) + cross((motion_.*w)(p.frame), axes * motion_.value(p.value));
    }
    return sum;
  }
  /// What the reference makes of the offset by turning.
  constexpr triple carried(const point& p, angular_velocities w) const {
    return cross((motion_.*w)(p.reference), motion_.vector_of(p.offset));
  }

  constexpr triple rate_from_origin(int place) const {
    triple sum;
    for (int p = place; p != none; p = m_.points[p].parent)
      sum = sum + rate_of(m_.points[p].offset, by_orientation);
    return sum;
  }

  /// As the equations of motion use it.
  constexpr triple velocity(int place) const {
    const point& p = m_.points[place];
    if (p.parent == none) return {};
    if (p.fixed_in != none)
      return velocity(p.parent) + cross(motion_.angular_velocity(p.fixed_in), motion_.vector_of(p.offset));
    if (!p.moves_by_declaration()) return velocity(p.parent) + rate_of(p.offset, as_used);
    const triple said = motion_.vector_of(p.velocity);
    return p.from_parent ? velocity(p.parent) + carried(p, as_used) + said : said;
  }

  const mechanism& m_;
  generic_motion motion_;
};

} // namespace detail

} // namespace kanexpr::mechanics
