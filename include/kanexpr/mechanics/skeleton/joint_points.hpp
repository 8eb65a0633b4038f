#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// The position of a joint's point along its axis is arbitrary; it is chosen so that offset components
/// vanish.
namespace kanexpr::mechanics {

/// If a point and its parent are fixed in the same frame, measures the point from the parent's parent.
constexpr void merge_rigid_offsets(skeleton& s, int from = 0) {
  for (int i = from; i < s.stations.size(); ++i) {
    station& n = s.stations[i];
    if (!n.rigid) continue;
    const station& parent = s.stations[n.parent];
    if (!parent.rigid || parent.frame != n.frame) continue;
    n.r = parent.r + n.r;
    n.parent = parent.parent;
  }
}

namespace detail {

/// The station from which all points of frame `f` are measured, if there is exactly one and no other frame
/// uses it; otherwise none.
constexpr int joint_station(const skeleton& s, int f) {
  int root = none;
  const auto hangs_at = [&](int n) {
    if (s.stations[n].frame == f && !s.stations[n].absolute) return true; // a point of f itself
    if (root == none) root = n;
    return root == n;
  };
  for (const station& n : s.stations)
    if (!n.absolute && n.frame == f && !hangs_at(n.parent)) return none;
  for (const link& l : s.links)
    if (l.frame == f && !hangs_at(l.station)) return none;
  if (root == none || !s.stations[root].rigid) return none;
  for (const station& n : s.stations)
    if (n.parent == root && (n.frame != f || !n.rigid)) return none;
  for (const link& l : s.links)
    if (l.station == root && l.frame != f) return none;
  return root;
}

constexpr int nonzero(const components& r) {
  return (r.x.is_zero() ? 0 : 1) + (r.y.is_zero() ? 0 : 1) + (r.z.is_zero() ? 0 : 1);
}

/// The number of nonzero offset components if the joint's point is moved along its axis by `along`.
constexpr int offsets_left(const skeleton& s, int root, const components& below, const components& above,
                           expression along) {
  const station& at = s.stations[root];
  int left = at.frame == mechanism::inertial ? 0 : nonzero(at.r + along * below);
  for (const station& n : s.stations)
    if (n.parent == root) left += nonzero(n.r - along * above);
  return left;
}

} // namespace detail

/// Slides joint points along their axes if this leaves fewer nonzero offset components; joints with
/// intersecting axes then share a point. Only numeric offsets are moved, because they are folded into
/// constants.
constexpr void place_joint_points(skeleton& s) {
  const mechanism& m = *s.model;
  for (int f = 1; f < m.frames.size(); ++f) {
    const int a = s.rigid_with[f] == f ? s.joint_axis(f) : none;
    if (a == none || s.body_axes[f] != f) continue;
    const int root = detail::joint_station(s, f);
    if (root == none || s.stations[root].frame != s.turns_in[f] || !s.stations[root].r.is_constant())
      continue;

    const components above = unit(*m.g, a);
    const components below = express(m, above, m.frames[f].parent, s.body_axes[s.stations[root].frame]);
    if (!below.is_constant()) continue;
    expression best = m.zero();
    int fewest = detail::offsets_left(s, root, below, above, best);
    const auto consider = [&](expression along) {
      if (!along.is_constant()) return;
      const int left = detail::offsets_left(s, root, below, above, along);
      if (left < fewest) best = along, fewest = left;
    };
    consider(-dot(s.stations[root].r, below));
    for (int n = root + 1; n < s.stations.size(); ++n)
      if (s.stations[n].parent == root) consider(s.stations[n].r[a]);
    if (best.is_zero()) continue;

    const components step = best * above;
    s.stations[root].r += best * below;
    for (station& n : s.stations)
      if (n.parent == root) n.r -= step;
    for (link& l : s.links)
      if (l.station == root) l.mass = shifted(l.mass, -step);
    const station where_it_was{
        .parent = root, .frame = f, .offset_frame = f, .r = -step, .rigid = true, .axes = f};
    int moved = none;
    for (int& n : s.station_of_point) {
      if (n != root) continue;
      if (moved == none) moved = s.stations.push(where_it_was);
      n = moved;
    }
  }
}

} // namespace kanexpr::mechanics
