#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>

#include <string_view>

/// Compares declared angular velocities with those that follow from orientations.
namespace kanexpr::mechanics {

namespace detail {

/// The axes, in the frame's own basis, about which a frame turns in addition to the motion that its
/// orientation describes. If there is more than one, no single angle explains the motion.
struct omitted_angle {
  int frame = none;
  span_of_triples axes{};
};

/// Compares declared angular velocities with orientations at generic states; an equality that holds at one
/// generic state holds identically. Whether an axis is constant is checked at three states.
///
/// The difference between a declared angular velocity and that of the orientation must be the spin of omitted
/// angles, such as the rotation angle of an axisymmetric wheel. A single omitted angle turns the frame about
/// an axis that is fixed in the frame and about which the angles of its orientation do not turn it.
class angular_velocity_checker {
public:
  constexpr angular_velocity_checker(const mechanism& m, const contents& held)
      : m_(m), held_(held), motion_(m, held) {
    for (int f = 0; f < m.frames.size(); ++f)
      if (m.frames[f].has_declared_angular_velocity())
        declared_.push({.frame = f, .all = {}, .bound = {}, .free = {}, .by_angles = {}, .before = {}});
  }

  constexpr base::sentence run() {
    bool open = false;  // there is a difference that must be explained
    bool moves = false; // a spin axis may move in its frame
    for (int state = 0, looked = 0; state < 6 && looked < (open || moves ? 3 : 1); ++state) {
      motion_.draw();
      if (motion_.has_free_speeds() && !take(false)) continue;
      if (take(true)) ++looked;
      for (const declared_angular_velocity& t : declared_) {
        is_any_apart_ = is_any_apart_ || t.all.size() != 0;
        open = open || t.bound.size() != 0;
        moves = moves || (t.all.size() != 0 && !is_spin_only(t.frame));
      }
    }
    if (open)
      for (int rates = 0; rates < 4; ++rates)
        if (motion_.move_freely())
          for (declared_angular_velocity& t : declared_)
            t.by_angles.add(in_own_axes(t.frame, by_orientation(t.frame)));
    for (const declared_angular_velocity& t : declared_)
      if (!m_.frames[t.frame].turns_apart && !is_explained(t))
        return base::sentence(
            {"the angular velocity of frame ", called(t.frame),
             " does not match its orientation, and no omitted angle explains the difference; if "
             "this is intended, write angular_velocity_apart_from_orientation<...>"});
    return {};
  }

  constexpr bool is_any_apart() const { return is_any_apart_; }

  constexpr sequence<omitted_angle> omitted_angles() const {
    sequence<omitted_angle> found;
    for (const declared_angular_velocity& t : declared_)
      if (t.all.size() != 0 && !m_.frames[t.frame].turns_apart) found.push({t.frame, t.all});
    return found;
  }

private:
  /// The differences found for one frame, in its own basis, over all states.
  struct declared_angular_velocity {
    int frame = none;
    span_of_triples all{};   ///< declared angular velocity minus that of the orientation
    span_of_triples bound{}; ///< the same difference without the speeds that appear in no kinematic equation
    span_of_triples free{};  ///< the contribution of these speeds
    span_of_triples by_angles{}; ///< the axes about which the orientation can turn the frame in its
                                 ///< reference, at one state
    triple before{};
  };

  constexpr std::string_view called(int f) const { return m_.frames[f].called.view(); }

  /// The angular velocity relative to the reference frame.
  constexpr triple by_orientation(int f) const {
    return motion_.by_orientation(f) - motion_.by_orientation(m_.frames[f].reference);
  }
  constexpr triple in_own_axes(int f, triple v) const { return motion_.basis(f).along(v); }

  constexpr bool take(bool with_free_speeds) {
    if (!motion_.move(with_free_speeds)) return false;
    for (declared_angular_velocity& t : declared_) {
      const int reference = m_.frames[t.frame].reference;
      if (!motion_.is_proper(t.frame) || !motion_.is_proper(reference)) continue;
      const triple declared = motion_.declared(t.frame), own = motion_.by_orientation(t.frame),
                   below = motion_.by_orientation(reference);
      const double rounding = 1e-9 * (length(declared) + length(own) + length(below)) + motion_.rounding();
      const triple left = in_own_axes(t.frame, declared - (own - below));
      if (!with_free_speeds) t.before = left;
      if (length(left) > rounding) (with_free_speeds ? t.all : t.bound).add(left);
      if (with_free_speeds && !motion_.has_free_speeds() && length(left) > rounding) t.bound.add(left);
      if (with_free_speeds && motion_.has_free_speeds() && length(left - t.before) > rounding)
        t.free.add(left - t.before);
    }
    return true;
  }

  constexpr bool is_explained(const declared_angular_velocity& t) const {
    // with two free speeds the orientation is unknown; other checks cover the quantities that depend on it
    if (t.bound.size() == 0 || t.free.size() > 1) return true;
    const bool own_is_fixed = is_fixed_in_parent(t.frame);
    if (t.all.size() == 1) return own_is_fixed || t.free.size() == 1 || !t.by_angles.holds(t.all);
    return own_is_fixed && (t.by_angles.size() == 0 || has_spherical_inertia(t.frame));
  }

  /// Whether a frame is declared only to spin about an axis of its parent.
  constexpr bool is_spin_only(int place) const {
    const frame& f = m_.frames[place];
    if (f.kind != orientation::about_basis || f.reference != f.parent || !is_fixed_in_parent(place))
      return false;
    for (const vector::part& p : f.angular_velocity.parts) {
      if (p.frame != place && p.frame != f.parent) return false;
      for (int i = 0; i < 3; ++i)
        if (i != f.axis && !p.value[i].is_zero()) return false;
    }
    return true;
  }

  constexpr bool is_fixed_in_parent(int place) const {
    const frame& f = m_.frames[place];
    return f.kind == orientation::matrix ? held_.is_fixed(f.to_parent) : held_.is_fixed(f.angle);
  }

  /// Whether all bodies of a frame have spherical inertia, so that none of its angles matters.
  constexpr bool has_spherical_inertia(int f) const {
    bool any = false;
    for (const flexible_body& b : m_.flexible_bodies)
      if (b.frame == f) return false;
    for (const body& b : m_.bodies) {
      if (b.frame != f) continue;
      any = true;
      if (b.inertia.parts.size() != 1) return false;
      const dyadic::part& p = b.inertia.parts[0];
      if (p.left != p.right || !is_round(p.value, 0) || !is_round(p.value, 1)) return false;
    }
    return any;
  }

  const mechanism& m_;
  const contents& held_;
  generic_motion motion_;
  sequence<declared_angular_velocity> declared_{};
  bool is_any_apart_ = false;
};

} // namespace detail

} // namespace kanexpr::mechanics
