#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// A symmetric dyadic in the axes of a frame: an inertia, with the sign of I = Σ m (r·r E − r r).
struct symmetric {
  expression xx, yy, zz, xy, yz, zx;

  static constexpr expression symmetric::* entry(int i, int j) {
    if (i == j) return i == 0 ? &symmetric::xx : i == 1 ? &symmetric::yy : &symmetric::zz;
    return i + j == 1 ? &symmetric::xy : i + j == 3 ? &symmetric::yz : &symmetric::zx;
  }

  constexpr symmetric() = default;
  constexpr explicit symmetric(graph& g) : symmetric(expression{g, graph::zero}) {}
  constexpr explicit symmetric(expression all) : xx(all), yy(all), zz(all), xy(all), yz(all), zx(all) {}
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.xx, self.yy, self.zz, self.xy, self.yz, self.zx);
  }
  constexpr expression& operator()(int i, int j) { return this->*entry(i, j); }
  constexpr const expression& operator()(int i, int j) const { return this->*entry(i, j); }
  constexpr bool is_zero() const {
    return xx.is_zero() && yy.is_zero() && zz.is_zero() && xy.is_zero() && yz.is_zero() && zx.is_zero();
  }
  constexpr bool is_constant() const {
    return xx.is_constant() && yy.is_constant() && zz.is_constant() && xy.is_constant() && yz.is_constant() &&
           zx.is_constant();
  }
  friend constexpr symmetric operator+(const symmetric& a, const symmetric& b) {
    symmetric s;
    s.xx = a.xx + b.xx, s.yy = a.yy + b.yy, s.zz = a.zz + b.zz;
    s.xy = a.xy + b.xy, s.yz = a.yz + b.yz, s.zx = a.zx + b.zx;
    return s;
  }
  friend constexpr symmetric operator*(expression factor, const symmetric& a) {
    symmetric s;
    s.xx = factor * a.xx, s.yy = factor * a.yy, s.zz = factor * a.zz;
    s.xy = factor * a.xy, s.yz = factor * a.yz, s.zx = factor * a.zx;
    return s;
  }
};

constexpr components operator*(const symmetric& a, const components& v) {
  return {dot({a.xx, a.xy, a.zx}, v), dot({a.xy, a.yy, a.yz}, v), dot({a.zx, a.yz, a.zz}, v)};
}

/// Returns the dyadic with the given entries in the axes of one frame.
constexpr dyadic dyadic_of(int axes, const symmetric& scalars) {
  matrix3 value;
  for (int i = 0; i < 3; ++i) value.row[i] = {scalars(i, 0), scalars(i, 1), scalars(i, 2)};
  return {{{axes, axes, value}}};
}

/// Whether an inertia, a `symmetric` or a matrix, is rotationally symmetric about axis `a`.
template <class Inertia>
constexpr bool is_round(const Inertia& i, int a) {
  const int b = (a + 1) % 3, d = (a + 2) % 3;
  return i(b, b) == i(d, d) && i(a, b).is_zero() && i(a, d).is_zero() && i(b, d).is_zero();
}

/// The mass properties of a rigid part about one of its points, in the axes of a frame: mass, first moment h
/// = Σ m r and inertia about the point.
struct rigid_mass {
  expression mass{};
  components first_moment{};
  symmetric inertia{};

  constexpr rigid_mass() = default;
  constexpr explicit rigid_mass(graph& g) : mass(g, graph::zero), first_moment(g), inertia(g) {}
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.mass, self.first_moment, self.inertia);
  }

  constexpr bool is_zero() const { return mass.is_zero() && first_moment.is_zero() && inertia.is_zero(); }
  constexpr bool is_constant() const {
    return mass.is_constant() && first_moment.is_constant() && inertia.is_constant();
  }
  constexpr rigid_mass& operator+=(const rigid_mass& other) {
    mass += other.mass;
    first_moment += other.first_moment;
    inertia = inertia + other.inertia;
    return *this;
  }
};

/// The mass properties about c, moved to p, where c is at p + r.
///
/// With h' = h + m r, the diagonal entry i increases by r·(h + h') − r_i (h_i + h'_i), and the off-diagonal
/// entries change by r_i h_j + r_j h'_i. This takes half as many multiplications as the usual form of the
/// parallel-axis theorem (derived in Featherstone 2008, eq. 2.63). Without mass, h' = h, and the diagonal
/// increases by twice the terms that also occur in the moments of forces at r.
constexpr rigid_mass shifted(const rigid_mass& at, const components& r) {
  rigid_mass to = at;
  const components& h = at.first_moment;
  to.first_moment = h + at.mass * r;
  const components& k = to.first_moment;
  if (at.mass.is_zero()) {
    const expression x = r.x * h.x, y = r.y * h.y, z = r.z * h.z;
    to.inertia.xx = at.inertia.xx + 2 * (y + z);
    to.inertia.yy = at.inertia.yy + 2 * (z + x);
    to.inertia.zz = at.inertia.zz + 2 * (x + y);
  } else {
    const expression x = r.x * (h.x + k.x), y = r.y * (h.y + k.y), z = r.z * (h.z + k.z);
    to.inertia.xx = at.inertia.xx + (y + z);
    to.inertia.yy = at.inertia.yy + (z + x);
    to.inertia.zz = at.inertia.zz + (x + y);
  }
  to.inertia.xy = at.inertia.xy - sum_of_products(r.x, h.y, r.y, k.x);
  to.inertia.yz = at.inertia.yz - sum_of_products(r.y, h.z, r.z, k.y);
  to.inertia.zx = at.inertia.zx - sum_of_products(r.z, h.x, r.x, k.z);
  return to;
}

} // namespace kanexpr::mechanics
