#pragma once

#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>

namespace kanexpr::mechanics {

/// Whether a frame is `other` or is oriented, directly or indirectly, relative to it.
constexpr bool is_oriented_by(const mechanism& m, int frame, int other) {
  while (frame != other && frame != none) frame = m.frames[frame].parent;
  return frame == other;
}

/// Whether the axes of a frame are constant in those of `other` for all values of the coordinates.
constexpr bool is_constant_in(const mechanism& m, int frame, int other) {
  for (int i = 0; i < 3; ++i)
    if (!is_fixed(express(m, unit(*m.g, i), frame, other))) return false;
  return true;
}

/// Whether a vector is given along axes that are constant in a frame, so that its direction in this frame
/// changes only through its components.
constexpr bool is_along_still_axes(const mechanism& m, const vector& v, int frame) {
  if (is_fixed(express(m, v, frame))) return true;
  for (const vector::part& p : v.parts)
    for (int i = 0; i < 3; ++i)
      if (!p.value[i].is_zero() && !is_fixed(express(m, unit(*m.g, i), p.frame, frame))) return false;
  return true;
}

/// Expresses those parts of a vector whose axes are constant in `frame` in the axes of `frame` itself, so
/// that these parts also rotate with the frame under auxiliary speeds.
constexpr vector turned_with(const mechanism& m, const vector& v, int frame) {
  vector out;
  for (const vector::part& p : v.parts)
    if (!is_oriented_by(m, p.frame, frame) && is_constant_in(m, p.frame, frame))
      out.add(frame, express(m, p.value, p.frame, frame));
    else
      out.add(p.frame, p.value);
  return out;
}

} // namespace kanexpr::mechanics
