#pragma once

#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// Where a joint's point stands on its axis is free: it is put where offsets vanish.
namespace kanexpr::mechanics {

/// A point that is fixed in the same frame as the point it was measured from is measured from that one's
/// parent.
constexpr void gather_rigid_steps(skeleton& s, int from = 0) {
  for (int i = from; i < s.nodes.size(); ++i) {
    node& n = s.nodes[i];
    if (!n.rigid) continue;
    const node& parent = s.nodes[n.parent];
    if (!parent.rigid || parent.frame != n.frame) continue;
    n.r = parent.r + n.r;
    n.parent = parent.parent;
  }
}

namespace detail {

/// The node at which all of frame `f` hangs, if there is a single one that carries nothing else; or none.
constexpr int joint_node(const skeleton& s, int f) {
  int root = none;
  const auto hangs_at = [&](int n) {
    if (s.nodes[n].frame == f && !s.nodes[n].absolute) return true; // a point of f itself
    if (root == none) root = n;
    return root == n;
  };
  for (const node& n : s.nodes)
    if (!n.absolute && n.frame == f && !hangs_at(n.parent)) return none;
  for (const link& l : s.links)
    if (l.frame == f && !hangs_at(l.node)) return none;
  if (root == none || !s.nodes[root].rigid) return none;
  for (const node& n : s.nodes)
    if (n.parent == root && (n.frame != f || !n.rigid)) return none;
  for (const link& l : s.links)
    if (l.node == root && l.frame != f) return none;
  return root;
}

constexpr int nonzero(const components& r) {
  return (r.x.is_zero() ? 0 : 1) + (r.y.is_zero() ? 0 : 1) + (r.z.is_zero() ? 0 : 1);
}

/// How many components of offsets are left when the joint's point moves by `along` its axis.
constexpr int offsets_left(const skeleton& s, int root, const components& below, const components& above,
                           expression along) {
  const node& at = s.nodes[root];
  int left = at.frame == mechanism::inertial ? 0 : nonzero(at.r + along * below);
  for (const node& n : s.nodes)
    if (n.parent == root) left += nonzero(n.r - along * above);
  return left;
}

} // namespace detail

/// Slides joint points along their axes where that leaves fewer offset components: intersecting axes come to
/// share a point. Only numbers are moved, since they fold.
constexpr void place_joint_points(skeleton& s) {
  const mechanism& m = *s.model;
  for (int f = 1; f < m.frames.size(); ++f) {
    const int a = s.rigid_with[f] == f ? s.joint_axis(f) : none;
    if (a == none || s.body_axes[f] != f) continue;
    const int root = detail::joint_node(s, f);
    if (root == none || s.nodes[root].frame != s.turns_in[f] || !s.nodes[root].r.is_constant()) continue;

    const components above = unit(*m.g, a);
    const components below = express(m, above, m.frames[f].parent, s.body_axes[s.nodes[root].frame]);
    if (!below.is_constant()) continue;
    expression best = m.zero();
    int fewest = detail::offsets_left(s, root, below, above, best);
    const auto consider = [&](expression along) {
      if (!along.is_constant()) return;
      const int left = detail::offsets_left(s, root, below, above, along);
      if (left < fewest) best = along, fewest = left;
    };
    consider(-dot(s.nodes[root].r, below));
    for (int n = root + 1; n < s.nodes.size(); ++n)
      if (s.nodes[n].parent == root) consider(s.nodes[n].r[a]);
    if (best.is_zero()) continue;

    const components step = best * above;
    s.nodes[root].r += best * below;
    for (node& n : s.nodes)
      if (n.parent == root) n.r -= step;
    for (link& l : s.links)
      if (l.node == root) l.mass = shifted(l.mass, -step);
    node where_it_was;
    where_it_was.parent = root;
    where_it_was.frame = where_it_was.axes = where_it_was.offset_frame = f;
    where_it_was.r = -step;
    where_it_was.rigid = true;
    int moved = none;
    for (int& n : s.node_of_point) {
      if (n != root) continue;
      if (moved == none) moved = s.nodes.push(where_it_was);
      n = moved;
    }
  }
}

} // namespace kanexpr::mechanics
