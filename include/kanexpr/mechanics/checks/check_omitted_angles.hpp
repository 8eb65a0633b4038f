#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_angular_velocity.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Checks for vectors that are given along the axes of a frame whose orientation omits an angle, and that
/// depend on this angle.
namespace kanexpr::mechanics {

namespace detail {

/// A wheel needs no angle if all vectors along its axes are parallel to its spin axis. The check evaluates
/// them at one generic state. It skips vectors that contain speeds, because they may be velocities, which do
/// not depend on the axes in which they are written.
class omitted_angles_checker {
public:
  constexpr omitted_angles_checker(const multibody_system& of, const contents& held,
                                   const sequence<omitted_angle>& angles)
      : m_(of.mechanism), held_(held), angles_(angles) {
    for (const omitted_angle& l : angles_) {
      collect_frames(l);
      collect_points(l, of.loads);
      for (const flexible_body& b : m_.flexible_bodies) {
        collect_part(l, {b.frame, b.first_moment}, "the first moment of ", b.called);
        for (const components& h : b.angular)
          collect_part(l, {b.frame, h}, "an angular integral of ", b.called);
      }
      for (const force& f : of.loads.forces) collect(l, f.value, "a force on ", m_.points[f.point].called);
      for (const torque& t : of.loads.torques) collect(l, t.value, "a torque on ", m_.frames[t.frame].called);
      for (int i = 0; i < of.constraints.on_velocities.size(); ++i)
        collect(l, of.constraints.on_velocities[i].direction, "a direction of velocity constraint ",
                base::counted(i + 1));
    }
  }

  constexpr sentence run() const {
    if (candidates_.empty()) return {};
    sequence<expression> wanted;
    for (const candidate& d : candidates_)
      for (int i = 0; i < 3; ++i) wanted.push(d.value[i]);
    generic_motion motion(m_, held_, wanted);
    if (!motion.find_state()) return {};
    for (const candidate& d : candidates_)
      if (depends(motion, d)) return sentence_for(d);
    return {};
  }

private:
  /// A vector that may depend on an omitted angle, with its name in messages, such as "a force on " and "P".
  struct candidate {
    const omitted_angle* angle = nullptr;
    int axes = none; ///< the frame along whose axes the vector is given
    components value{};
    std::string_view of{};
    name whose{};
    bool is_angular_velocity = false;
  };

  /// Whether a frame turns with another frame because it is oriented relative to that frame.
  constexpr bool turns_with(int f, int other) const {
    while (f != other && f != mechanism::inertial && !m_.frames[f].has_declared_angular_velocity())
      f = m_.frames[f].parent;
    return f == other;
  }

  constexpr void collect(const omitted_angle& l, const vector& v, std::string_view of, const name& whose) {
    for (const vector::part& p : v.parts) {
      bool is_velocity = false;
      for (int i = 0; i < 3; ++i)
        is_velocity = is_velocity ||
                      held_.holds_any(p.value[i], {contents::kind::speed, contents::kind::coordinate_rate});
      if (!is_velocity) collect_part(l, p, of, whose);
    }
  }
  constexpr void collect_part(const omitted_angle& l, const vector::part& p, std::string_view of,
                              const name& whose, bool is_angular_velocity = false) {
    if (!p.value.is_zero() && turns_with(p.frame, l.frame))
      candidates_.push({&l, p.frame, p.value, of, whose, is_angular_velocity});
  }

  constexpr void collect_frames(const omitted_angle& l) {
    const frame& omitting = m_.frames[l.frame];
    for (const vector::part& p : omitting.angular_velocity.parts)
      collect_part(l, p, "the angular velocity of frame ", omitting.called, true);
    for (int f = 0; f < m_.frames.size(); ++f) {
      const frame& own = m_.frames[f];
      if (f == l.frame || own.has_declared_angular_velocity() || !turns_with(f, l.frame)) continue;
      if (held_.is_fixed(own)) continue;
      const auto push = [&](const components& axis) {
        candidates_.push({&l, own.parent, axis, "the axis of frame ", own.called});
      };
      if (own.kind == orientation::about_axis)
        push(own.direction);
      else if (own.kind == orientation::about_basis)
        push(unit(*m_.g, own.axis));
      else // any axis is parallel to at most one of two basis vectors
        push(unit(*m_.g, 0)), push(unit(*m_.g, 1));
    }
  }

  /// Collects the offsets of points that carry mass or loads.
  constexpr void collect_points(const omitted_angle& l, const loads& given) {
    sequence<char> carries(m_.points.size(), 0);
    const auto reach = [&](int p) {
      for (; p != none && carries[p] == 0; p = m_.points[p].parent) carries[p] = 1;
    };
    for (const body& b : m_.bodies) reach(b.center);
    for (const flexible_body& b : m_.flexible_bodies) reach(b.reference);
    given.each([&](const auto& load, int) {
      if constexpr (requires { load.point; }) reach(load.point), reach(load.against);
    });
    for (int p = 0; p < m_.points.size(); ++p)
      if (carries[p] != 0) collect(l, m_.points[p].offset, "the offset of point ", m_.points[p].called);
  }

  constexpr bool depends(const generic_motion& motion, const candidate& d) const {
    const int f = d.angle->frame;
    if (!motion.is_proper(f) || !motion.is_proper(d.axes)) return false;
    // if the reference is at rest, the angular velocity of a ball does not depend on whether it is given
    // along the ball's own axes
    if (d.is_angular_velocity && d.angle->axes.size() > 1 && !(length(motion.by_orientation(f)) > 0))
      return false;
    const triple v = motion.basis(f).along(motion.basis(d.axes) * motion.value(d.value));
    return length(v) > 0 && (d.angle->axes.size() > 1 || !d.angle->axes.holds(v));
  }

  constexpr sentence sentence_for(const candidate& d) const {
    const std::string_view turns = m_.frames[d.angle->frame].called.view();
    return sentence({d.of, d.whose.view(), " is given along the axes of ", m_.frames[d.axes].called.view(),
                     " and depends on the omitted angle of ", turns, "; give ", turns,
                     " this angle, or write angular_velocity_apart_from_orientation<...>"});
  }

  const mechanism& m_;
  const contents& held_;
  const sequence<omitted_angle>& angles_;
  sequence<candidate> candidates_{};
};

} // namespace detail

} // namespace kanexpr::mechanics
