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

/// Vectors given along the axes of a frame whose orientation omits an angle, and that depend on this angle.
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
      collect_loads(l, of.loads);
      for (int i = 0; i < of.constraints.on_velocities.size(); ++i)
        collect(l, of.constraints.on_velocities[i].direction, what::direction, i);
    }
  }

  constexpr sentence run() const {
    if (candidates_.empty()) return {};
    sequence<expression> wanted;
    for (const candidate& d : candidates_)
      for (int i = 0; i < 3; ++i) wanted.push(d.value[i]);
    generic_motion motion(m_, held_, wanted);
    for (int states = 0; states < 6; ++states) {
      motion.draw();
      if (!motion.move()) continue;
      for (const candidate& d : candidates_)
        if (depends(motion, d)) return sentence_for(d);
      break;
    }
    return {};
  }

private:
  enum class what { axis, angular_velocity, offset, load, direction };

  struct candidate {
    const omitted_angle* angle = nullptr;
    int axes = none; ///< the frame along whose axes the vector is given
    components value{};
    what is = what::axis;
    int of = none;
    std::string_view load{}, loaded{}; ///< such as "a force on " and "P"
  };

  /// Whether a frame turns with another one because it is oriented relative to it.
  constexpr bool turns_with(int f, int other) const {
    while (f != other && f != mechanism::inertial && !m_.frames[f].has_declared_angular_velocity())
      f = m_.frames[f].parent;
    return f == other;
  }

  constexpr void collect(const omitted_angle& l, const vector& v, what is, int of) {
    for (const vector::part& p : v.parts) {
      bool is_sound = p.value.is_zero() || !turns_with(p.frame, l.frame);
      for (int i = 0; i < 3 && is != what::angular_velocity; ++i)
        is_sound =
            is_sound || held_.holds_any(p.value[i], {contents::kind::speed, contents::kind::coordinate_rate});
      if (!is_sound) candidates_.push({&l, p.frame, p.value, is, of, {}, {}});
    }
  }

  constexpr void collect_frames(const omitted_angle& l) {
    collect(l, m_.frames[l.frame].angular_velocity, what::angular_velocity, l.frame);
    for (int f = 0; f < m_.frames.size(); ++f) {
      const frame& own = m_.frames[f];
      if (f == l.frame || own.has_declared_angular_velocity() || !turns_with(f, l.frame)) continue;
      if (own.kind == orientation::matrix) {
        for (int axis = 0; axis < 2 && !held_.is_fixed(own.to_parent);
             ++axis) // any axis is parallel to at most one of the two basis vectors
          candidates_.push({&l, own.parent, unit(*m_.g, axis), what::axis, f, {}, {}});
      } else if (!held_.is_fixed(own.angle)) {
        candidates_.push({&l,
                          own.parent,
                          own.kind == orientation::about_basis ? unit(*m_.g, own.axis) : own.direction,
                          what::axis,
                          f,
                          {},
                          {}});
      }
    }
  }

  /// Collects the offsets of points that carry mass or loads.
  constexpr void collect_points(const omitted_angle& l, const loads& given) {
    sequence<char> carries(m_.points.size(), 0);
    const auto reach = [&](int p) {
      for (; p != none && carries[p] == 0; p = m_.points[p].parent) carries[p] = 1;
    };
    for (const body& b : m_.bodies) reach(b.center);
    given.each([&](const auto& load, int) { load.each_point(reach); });
    for (int p = 0; p < m_.points.size(); ++p)
      if (carries[p] != 0) collect(l, m_.points[p].offset, what::offset, p);
  }

  constexpr void collect_loads(const omitted_angle& l, const loads& given) {
    given.each([&](const auto& load, int) {
      load.each_vector(m_, [&](const vector& v, std::string_view word, std::string_view loaded) {
        const int before = candidates_.size();
        collect(l, v, what::load, none);
        for (int i = before; i < candidates_.size(); ++i)
          candidates_[i].load = word, candidates_[i].loaded = loaded;
      });
    });
  }

  constexpr bool depends(const generic_motion& motion, const candidate& d) const {
    const int f = d.angle->frame;
    if (!motion.is_proper(f) || !motion.is_proper(d.axes)) return false;
    // if the reference is at rest, the angular velocity of a ball does not depend on whether it is given
    // along the ball's own axes
    if (d.is == what::angular_velocity && d.angle->axes.size() > 1 && !(length(motion.by_orientation(f)) > 0))
      return false;
    const triple v = motion.basis(f).along(motion.basis(d.axes) * motion.value(d.value));
    return length(v) > 0 && (d.angle->axes.size() > 1 || !d.angle->axes.holds(v));
  }

  constexpr sentence sentence_for(const candidate& d) const {
    const auto sentence_about = [&](std::string_view of, std::string_view whose) {
      const std::string_view turns = m_.frames[d.angle->frame].called.view();
      return sentence({of, whose, " is given along the axes of ", m_.frames[d.axes].called.view(),
                       " and depends on the omitted angle of ", turns, "; give ", turns,
                       " this angle, or write angular_velocity_apart_from_orientation<...>"});
    };
    switch (d.is) {
    case what::axis: return sentence_about("the axis of frame ", m_.frames[d.of].called.view());
    case what::angular_velocity:
      return sentence_about("the angular velocity of frame ", m_.frames[d.of].called.view());
    case what::offset: return sentence_about("the offset of point ", m_.points[d.of].called.view());
    case what::load: return sentence_about(d.load, d.loaded);
    case what::direction:
      return sentence_about("a direction of velocity constraint ", base::counted(d.of + 1).view());
    }
    return {};
  }

  const mechanism& m_;
  const contents& held_;
  const sequence<omitted_angle>& angles_;
  sequence<candidate> candidates_{};
};

} // namespace detail

} // namespace kanexpr::mechanics
