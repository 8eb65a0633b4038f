#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// The choice of axes in which the quantities of a frame are formed: axes in which they are constant or
/// sparse, and in which the next transformation costs nothing.
namespace kanexpr::mechanics {

namespace detail {

/// Whether a flexible body deforms relative to frame `f`. Its integrals are shortest in its own axes.
constexpr bool carries_flexible_body(const skeleton& s, int f) {
  for (const flexible_body& b : s.model->flexible_bodies)
    if (s.rigid_with[b.frame] == f) return true;
  return false;
}

/// The frames in whose axes the masses and offsets of frame `f` are given.
constexpr sequence<int> axes_used_by(const skeleton& s, int f) {
  const mechanism& m = *s.model;
  sequence<int> used;
  const auto note = [&](int frame) {
    const int representative = s.rigid_with[frame];
    if (!used.contains(representative)) used.push(representative);
  };
  for (const body& b : m.bodies)
    if (b.frame != none && s.rigid_with[b.frame] == f)
      for (const dyadic::part& p : b.inertia.parts) note(p.left), note(p.right);
  if (carries_flexible_body(s, f)) note(f);
  for (const station& n : s.stations)
    if (n.frame == f && n.rigid && !n.absolute && !n.r.is_zero()) note(n.offset_frame);
  return used;
}

/// Whether all masses and offsets that move with `f` are rotationally symmetric about axis `a`. If they are,
/// the spin of f about this axis does not change them, and non-spinning axes can be used.
constexpr bool axisymmetric(const skeleton& s, int f, int a) {
  const mechanism& m = *s.model;
  const int b = (a + 1) % 3, d = (a + 2) % 3;
  if (carries_flexible_body(s, f)) return false;
  for (const body& part : m.bodies) {
    if (part.frame == none || s.rigid_with[part.frame] != f) continue;
    if (part.about != none && part.about != part.center) return false;
    if (!is_round(express(m, part.inertia, f), a)) return false;
  }
  for (const station& n : s.stations) {
    if (n.frame != f || n.absolute) continue;
    if (s.rigid_with[n.offset_frame] != f) return false;
    const components r = express(m, n.r, n.offset_frame, f);
    if (!r[b].is_zero() || !r[d].is_zero()) return false;
  }
  return true;
}

/// The frames along whose axes points move relative to their own frames.
constexpr sequence<int> axes_of_moving_points(const skeleton& s) {
  sequence<int> found;
  for (const station& n : s.stations)
    for (const vector::part& p : n.relative_velocity.parts)
      if (const int f = s.rigid_with[p.frame]; !found.contains(f)) found.push(f);
  return found;
}

/// Whether all rotations of the mechanism are about the same axis of the ground and all offsets are given in
/// the ground's axes, and whether no body is flexible.
constexpr bool planar(const skeleton& s) {
  if (!s.model->flexible_bodies.empty()) return false;
  int axis = none;
  for (int f : axes_of_moving_points(s))
    if (f != mechanism::inertial) return false;
  for (int f = 1; f < s.rigid_with.size(); ++f) {
    const frame& own = s.model->frames[f];
    if (own.kind == orientation::about_basis) {
      if (axis == none) axis = own.axis;
      if (axis != own.axis) return false;
    } else if (own.has_declared_angular_velocity() || !own.to_parent.is_identity()) {
      return false;
    }
  }
  return true;
}

/// The only frame that rotates in the ground, in which all others then rotate; the ground if there are
/// several, or if points move relative to frames, which they do along axes of the ground.
constexpr int first_rotating_frame(const skeleton& s) {
  int first = none;
  if (!axes_of_moving_points(s).empty()) return mechanism::inertial;
  for (int f = 1; f < s.rigid_with.size(); ++f) {
    if (s.rigid_with[f] != f || s.turns_in[f] != mechanism::inertial) continue;
    if (first != none) return mechanism::inertial;
    first = f;
  }
  return first == none ? mechanism::inertial : first;
}

/// Whether no other frame rotates in frame `f`.
constexpr bool carries_no_frame(const skeleton& s, int f) {
  for (int g = 1; g < s.rigid_with.size(); ++g)
    if (s.rigid_with[g] == g && s.turns_in[g] == f) return false;
  return true;
}

/// Whether the equations of frame `f` are written in the axes of the frame below: its inertia is needed there
/// in any case, and nothing farther out would have to be turned twice.
constexpr bool is_last_of_spatial_chain(const skeleton& s, int f) {
  const int below = s.turns_in[f];
  return s.joint_axis(f) != none && below != mechanism::inertial && s.body_axes[f] == f &&
         s.working_axes[below] == below && !carries_flexible_body(s, f) &&
         !axes_of_moving_points(s).contains(f) && carries_no_frame(s, f);
}

/// Whether `f` and its parent frame rotate about the same axis.
constexpr bool parallel_to_parent(const skeleton& s, int f) {
  const int axis = s.joint_axis(f);
  if (axis == none) return false;
  int below = s.model->frames[f].parent;
  while (s.rigid_with[below] != below) {
    const frame& between = s.model->frames[below];
    if (between.kind == orientation::about_basis || !between.to_parent.is_identity()) return false;
    below = between.parent;
  }
  return below != mechanism::inertial && s.joint_axis(below) == axis;
}

} // namespace detail

constexpr void choose_body_axes(skeleton& s) {
  s.body_axes = s.rigid_with;
  for (int f = 1; f < s.rigid_with.size(); ++f) {
    if (s.rigid_with[f] != f) continue;
    const sequence<int> used = detail::axes_used_by(s, f);
    const int below = s.model->frames[f].parent;
    if (used.size() == 1 && used[0] != f)
      s.body_axes[f] = used[0];
    else if (!used.empty() && s.rigid_with[below] == below &&
             s.model->frames[f].kind == orientation::about_basis &&
             detail::axisymmetric(s, f, s.model->frames[f].axis))
      s.body_axes[f] = below;
  }
}

/// Chooses the working axes of all frames. They are the body axes, except for successive frames that rotate
/// about parallel axes: these share the axes of the preceding frame, in which the common axis is constant, so
/// that no transformation is needed between them. In a planar mechanism, these are the axes of the first
/// frame, whose own vectors are constant in them. The last frame of a chain has those of the frame below. The
/// formulation of the model may determine others.
constexpr void choose_working_axes(skeleton& s) {
  s.working_axes = s.body_axes;
  const bool planar = detail::planar(s);
  const int common = planar ? detail::first_rotating_frame(s) : mechanism::inertial;
  for (int f = 1; f < s.rigid_with.size(); ++f) {
    if (s.rigid_with[f] != f) continue;
    if (planar) {
      s.working_axes[f] = common;
    } else if (s.body_axes[f] == f && !detail::carries_flexible_body(s, f) &&
               detail::parallel_to_parent(s, f)) {
      int below = s.rigid_with[s.model->frames[f].parent];
      if (s.working_axes[below] == below && !detail::carries_flexible_body(s, below))
        s.working_axes[below] = s.working_axes[s.rigid_with[s.model->frames[below].parent]];
      s.working_axes[f] = s.working_axes[below];
    } else if (detail::is_last_of_spatial_chain(s, f)) {
      s.working_axes[f] = s.working_axes[s.turns_in[f]];
    }
  }
  for (const formulation_of_frame& given : s.model->formulated.frames) {
    const int f = s.rigid_with[given.frame];
    if (given.axes != none && f != mechanism::inertial && !detail::carries_flexible_body(s, f))
      s.working_axes[f] = given.axes;
  }
  for (int f = 1; f < s.rigid_with.size(); ++f) {
    s.body_axes[f] = s.body_axes[s.rigid_with[f]];
    s.working_axes[f] = s.working_axes[s.rigid_with[f]];
  }
}

/// Chooses the axes of frames without mass, from index `from` on: the axes of the parent if both rotate about
/// parallel axes.
constexpr void choose_axes_from(skeleton& s, int from) {
  for (int f = from; f < s.rigid_with.size(); ++f) {
    const int representative = s.rigid_with[f];
    const bool is_new = representative == f;
    s.body_axes.push(is_new ? f : s.body_axes[representative]);
    s.working_axes.push(!is_new                            ? s.working_axes[representative]
                        : detail::parallel_to_parent(s, f) ? s.working_axes[s.model->frames[f].parent]
                                                           : f);
  }
}

} // namespace kanexpr::mechanics
