#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>

namespace kanexpr::mechanics {

/// One rotation of a vector's axes: about a basis vector, which costs four products, or by a matrix.
struct elementary_rotation {
  bool about_basis = true;
  int axis = 0;
  expression angle{}; ///< angle of the old axes relative to the new ones
  matrix3 to_new{};
  const components* about =
      nullptr; ///< the axis of `to_new`, whose components it keeps; null if it is not known
};

/// Whether two vectors, neither of which is zero, are parallel in every configuration.
constexpr bool are_parallel(const components& a, const components& b) {
  for (int i = 0; i < 3; ++i)
    if (a[i].is_zero() != b[i].is_zero()) return false;
  return cross(a, b).is_zero();
}

constexpr components turned(const elementary_rotation& h, const components& v) {
  if (!h.about_basis) return h.about != nullptr && are_parallel(v, *h.about) ? v : h.to_new * v;
  const int b = (h.axis + 1) % 3, d = (h.axis + 2) % 3;
  const expression s = sin(h.angle), c = cos(h.angle);
  components out = v;
  out[b] = difference_of_products(c, v[b], s, v[d]);
  out[d] = sum_of_products(s, v[b], c, v[d]);
  return out;
}

/// A symmetric dyadic in rotated axes. For a rotation about a basis vector a, with e = s²(I_bb − I_dd) + 2sc
/// I_bd, the new diagonal entries are I_bb − e and I_dd + e, and the new product of inertia is sc(I_bb −
/// I_dd) + (1 − 2s²) I_bd; row a transforms like a vector.
constexpr symmetric turned(const elementary_rotation& h, const symmetric& m) {
  symmetric out = m;
  if (!h.about_basis) {
    matrix3 half; // row j: m · (row j of to_new)
    for (int j = 0; j < 3; ++j) half.row[j] = m * h.to_new.row[j];
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) out(i, j) = dot(h.to_new.row[i], half.row[j]);
    return out;
  }
  const int a = h.axis, b = (a + 1) % 3, d = (a + 2) % 3;
  const expression s = sin(h.angle), c = cos(h.angle);
  const expression difference = m(b, b) - m(d, d);
  const expression ss = s * s, sc = s * c;
  const expression by_difference = ss * difference, by_product = (2 * sc) * m(b, d);
  const expression e = by_difference + by_product;
  out(b, b) = m(b, b) - e;
  out(d, d) = m(d, d) + e;
  out(b, d) = sc * difference;
  out(b, d) += (1 - 2 * ss) * m(b, d);
  out(a, b) = difference_of_products(c, m(a, b), s, m(d, a));
  out(d, a) = sum_of_products(s, m(a, b), c, m(d, a));
  return out;
}

/// The path from the axes of one frame to those of another: up to the common ancestor and down again.
///
/// Successive rotations about the same axis are merged into a rotation by the sum of their angles.
class path {
public:
  constexpr path(const mechanism& m, int from, int to) {
    if (from == to) return;
    const int meeting = common_ancestor(m, from, to);
    climb(m, from, meeting);
    push_turns(m, to, meeting, false);
  }

  constexpr const sequence<elementary_rotation>& rotations() const { return rotations_; }

  template <class Quantity>
  constexpr Quantity turn(Quantity v) const {
    for (const elementary_rotation& h : rotations_) v = turned(h, v);
    return v;
  }

  static constexpr int depth(const mechanism& m, int f) {
    const frame* const frames = m.frames.begin(); // a pointer, because compilers interpret every call
    int n = 0;
    for (; f != mechanism::inertial; f = frames[f].parent) ++n;
    return n;
  }
  static constexpr int common_ancestor(const mechanism& m, int a, int b) {
    if (a == mechanism::inertial || b == mechanism::inertial) return mechanism::inertial;
    const frame* const frames = m.frames.begin();
    int i = depth(m, a), j = depth(m, b);
    for (; i > j; --i) a = frames[a].parent;
    for (; j > i; --j) b = frames[b].parent;
    while (a != b) a = frames[a].parent, b = frames[b].parent;
    return a;
  }

private:
  /// Builds the path from the common ancestor outward and then reverses it, so that the angles of a chain add
  /// up as running sums.
  constexpr void climb(const mechanism& m, int from, int meeting) {
    push_turns(m, from, meeting, true);
    std::reverse(rotations_.begin(), rotations_.end());
  }
  /// Adds the rotations of the frames between `meeting` and `end`, from the innermost outward.
  constexpr void push_turns(const mechanism& m, int end, int meeting, bool is_upward) {
    const sequence<int> way = way_down(m, end, meeting);
    const frame* const frames = m.frames.begin();
    const int* const places = way.begin();
    int axis = none, angle = 0; // of the last rotation, to which more may be added
    for (int i = way.size() - 1; i >= 0; --i) {
      const frame& f = frames[places[i]];
      if (f.kind == orientation::about_basis) {
        int turn = f.angle.node();
        if (!is_upward) turn = symbolic::negate(*m.g, turn);
        if (f.axis == axis) {
          angle = symbolic::add(*m.g, angle, turn);
          continue;
        }
        if (axis != none) rotations_.push({true, axis, {*m.g, angle}, matrix3{}});
        axis = f.axis, angle = turn;
      } else if (!f.to_parent.is_identity()) {
        if (axis != none) rotations_.push({true, axis, {*m.g, angle}, matrix3{}});
        axis = none;
        rotations_.push({false, 0, expression{}, is_upward ? f.to_parent : transpose(f.to_parent),
                         f.kind == orientation::about_axis ? &f.direction : nullptr});
      }
    }
    if (axis != none) rotations_.push({true, axis, {*m.g, angle}, matrix3{}});
  }
  /// The frames from `f` to the child of `meeting`, in ascending order.
  static constexpr sequence<int> way_down(const mechanism& m, int f, int meeting) {
    sequence<int> way;
    const frame* const frames = m.frames.begin();
    for (; f != meeting; f = frames[f].parent) way.push(f);
    return way;
  }

  sequence<elementary_rotation> rotations_{};
};

/// Whether a vector keeps its components between two frames, because all rotations between them are about the
/// basis vector along which it points, as in planar chains.
constexpr bool keeps_components(const mechanism& m, const components& v, int from, int to) {
  int axis = none;
  for (int i = 0; i < 3; ++i)
    if (v[(i + 1) % 3].is_zero() && v[(i + 2) % 3].is_zero()) axis = i;
  if (axis == none) return false;
  const frame* const frames = m.frames.begin(); // a frame comes after its parent
  while (from != to) {
    int& farther = from > to ? from : to;
    const frame& f = frames[farther];
    if (f.kind != orientation::about_basis || f.axis != axis) return false;
    farther = f.parent;
  }
  return true;
}

constexpr components express(const mechanism& m, const components& v, int from, int to) {
  if (from == to || v.is_zero() || keeps_components(m, v, from, to)) return v;
  return path(m, from, to).turn(v); // not in a conditional expression: g++ 12 would destroy the path twice
}

/// Expresses a sum over frames in the axes of one frame. The running sum starts at the farthest frame, is
/// transformed rotation by rotation, and collects the other parts on its path.
constexpr components express(const mechanism& m, const vector& v, int to) {
  if (v.parts.size() == 1) return express(m, v.parts[0].value, v.parts[0].frame, to); // most vectors
  sequence<vector::part> left = v.parts;
  components total(*m.g);
  while (!left.empty()) {
    int farthest = 0, rotations = -1;
    for (int i = 0; i < left.size(); ++i) {
      const int meeting = path::common_ancestor(m, left[i].frame, to);
      const int n = path::depth(m, left[i].frame) + path::depth(m, to) - 2 * path::depth(m, meeting);
      if (n > rotations) farthest = i, rotations = n;
    }
    const vector::part part = left[farthest];
    left[farthest] = left.back();
    left.pop();
    if (rotations == 0) {
      total += part.value;
      continue;
    }
    const int meeting = path::common_ancestor(m, part.frame, to);
    int next = part.frame;
    bool met = false; // stop at the next frame on the path that has a part
    const auto has_part = [&](int f) {
      for (const vector::part& p : left)
        if (p.frame == f) return true;
      return false;
    };
    while (!met && next != meeting) {
      next = m.frames[next].parent;
      met = has_part(next);
    }
    if (!met) {
      next = to;
      for (int f = to; f != meeting; f = m.frames[f].parent)
        if (has_part(f)) next = f; // the last match is the one nearest to the common ancestor
    }
    const components arrived = express(m, part.value, part.frame, next);
    bool joined = false;
    for (vector::part& p : left)
      if (p.frame == next) p.value += arrived, joined = true;
    if (!joined) left.push({next, arrived});
  }
  return total;
}

/// The matrix of a dyadic in the axes of one frame.
constexpr matrix3 express(const mechanism& m, const dyadic& d, int to) {
  matrix3 total(*m.g);
  for (const dyadic::part& p : d.parts) {
    matrix3 half = transpose(p.value); // row j: column j of the value, a vector in the left axes
    for (int j = 0; j < 3; ++j) half.row[j] = express(m, half.row[j], p.left, to);
    half = transpose(half);
    for (int i = 0; i < 3; ++i) total.row[i] += express(m, half.row[i], p.right, to);
  }
  return total;
}

} // namespace kanexpr::mechanics
