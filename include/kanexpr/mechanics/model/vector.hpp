#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The index that denotes no frame, point or body.
inline constexpr int none = -1;

/// A vector as a sum over frames: each part has components in the axes of one frame.
struct vector {
  struct part {
    int frame = none;
    components value{};
  };
  sequence<part> parts{};

  constexpr void add(int frame, const components& value) {
    for (part& p : parts)
      if (p.frame == frame) {
        p.value += value;
        return;
      }
    parts.push({frame, value});
  }
  constexpr void add(const vector& other) {
    for (const part& p : other.parts) add(p.frame, p.value);
  }
  constexpr void subtract(const vector& other) {
    for (const part& p : other.parts) add(p.frame, -p.value);
  }
  constexpr bool is_zero() const {
    for (const part& p : parts)
      if (!p.value.is_zero()) return false;
    return true;
  }
  /// Calls `visit` with every component of every part.
  template <class Visit>
  constexpr void each_entry(const Visit& visit) const {
    for (const part& p : parts) visit(p.value.x), visit(p.value.y), visit(p.value.z);
  }
};

/// Adds a scalar, or the components of a vector, to a list.
constexpr void push_entries(sequence<expression>& all, expression e) { all.push(e); }
constexpr void push_entries(sequence<expression>& all, const vector& v) {
  v.each_entry([&](expression e) { all.push(e); });
}

constexpr vector operator*(expression s, const vector& v) {
  vector out;
  for (const vector::part& p : v.parts) out.parts.push({p.frame, scaled(s, p.value)});
  return out;
}

constexpr vector operator+(vector a, const vector& b) {
  a.add(b);
  return a;
}
constexpr vector operator-(vector a, const vector& b) {
  a.subtract(b);
  return a;
}
constexpr vector operator-(const vector& v) {
  vector turned;
  turned.subtract(v);
  return turned;
}

/// A dyadic as a sum over pairs of frames: Σ value(i,j) left.i ⊗ right.j.
struct dyadic {
  struct part {
    int left = none;
    int right = none;
    matrix3 value{};
  };
  sequence<part> parts{};

  constexpr void add(int left, int right, const matrix3& value) {
    for (part& p : parts)
      if (p.left == left && p.right == right) {
        for (int i = 0; i < 3; ++i) p.value.row[i] += value.row[i];
        return;
      }
    parts.push({left, right, value});
  }
  constexpr void add(const dyadic& other) {
    for (const part& p : other.parts) add(p.left, p.right, p.value);
  }
  /// Whether the dyadic is given in the axes of a single frame.
  constexpr bool is_in_one_frame() const { return parts.size() == 1 && parts[0].left == parts[0].right; }
  /// Calls `visit` with every entry of every part.
  template <class Visit>
  constexpr void each_entry(const Visit& visit) const {
    for (const part& p : parts)
      for (const components& row : p.value.row) visit(row.x), visit(row.y), visit(row.z);
  }
};

constexpr dyadic operator*(expression s, const dyadic& d) {
  dyadic scaled;
  for (const dyadic::part& p : d.parts) {
    matrix3 value;
    for (int i = 0; i < 3; ++i) value.row[i] = s * p.value.row[i];
    scaled.parts.push({p.left, p.right, value});
  }
  return scaled;
}

constexpr dyadic operator+(dyadic a, const dyadic& b) {
  a.add(b);
  return a;
}

} // namespace kanexpr::mechanics
