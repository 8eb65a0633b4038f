#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::mechanics {

using base::name;
using base::sequence;
using symbolic::expression;
using symbolic::graph;

/// The three measure numbers of a vector in the axes of a frame.
struct components {
  expression x, y, z;

  constexpr components() = default;
  constexpr components(expression x_, expression y_, expression z_) : x(x_), y(y_), z(z_) {}
  constexpr explicit components(graph& g) : x(g, graph::zero), y(x), z(x) {}
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.x, self.y, self.z);
  }

  constexpr expression& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const expression& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr bool is_zero() const { return x.is_zero() && y.is_zero() && z.is_zero(); }
  constexpr bool is_constant() const { return x.is_constant() && y.is_constant() && z.is_constant(); }
  constexpr bool operator==(const components&) const = default;

  friend constexpr components operator+(const components& a, const components& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr components operator-(const components& a, const components& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr components operator-(const components& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr components operator*(expression s, const components& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  constexpr components& operator+=(const components& b) { return *this = *this + b; }
  constexpr components& operator-=(const components& b) { return *this = *this - b; }
};

namespace detail {

/// `factor · rest`, which equals an expression up to sign.
struct factored {
  expression rest;
  bool found = false;
};

constexpr factored without_factor(expression e, int factor) {
  graph& g = e.owner();
  const bool negative = g[e.node()].op == symbolic::operation::negate;
  const symbolic::node n = g[negative ? g[e.node()].a : e.node()];
  if (n.op != symbolic::operation::multiply || (n.a != factor && n.b != factor)) return {};
  const expression rest{g, n.a == factor ? n.b : n.a};
  return {negative ? -rest : rest, true};
}

} // namespace detail

/// Returns s v. If all components of v have a common factor, s multiplies that factor only once.
constexpr components scaled(expression s, const components& v) {
  graph& g = s.owner();
  const expression& first = !v.x.is_zero() ? v.x : v.y;
  const symbolic::node n =
      g[g[first.node()].op == symbolic::operation::negate ? g[first.node()].a : first.node()];
  if (n.op != symbolic::operation::multiply) return s * v;
  for (int factor : {n.a, n.b}) {
    if (g.is_constant(factor)) continue;
    components rest = v;
    int shared = 0, others = 0;
    for (int i = 0; i < 3; ++i) {
      if (v[i].is_zero()) continue;
      const detail::factored f = detail::without_factor(v[i], factor);
      if (f.found)
        rest[i] = f.rest, ++shared;
      else
        ++others;
    }
    if (shared > 1 && others == 0) return (s * expression{g, factor}) * rest;
  }
  return s * v;
}

constexpr expression dot(const components& a, const components& b) {
  const expression in_plane = sum_of_products(a.x, b.x, a.y, b.y), along_z = a.z * b.z;
  return in_plane + along_z;
}

constexpr components cross(const components& a, const components& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The unit vector along a vector; a vector of length 1 needs no root.
constexpr components unit_along(const components& v) {
  const expression square = dot(v, v);
  if (square.is_one() || square.is_zero()) return v;
  return (1 / sqrt(square)) * v;
}

/// The unit vector along axis `i` (0, 1, 2).
constexpr components unit(graph& g, int i) {
  components e(g);
  e[i] = expression{g, graph::one};
  return e;
}

/// A 3×3 matrix, stored in row-major order.
struct matrix3 {
  components row[3];

  constexpr matrix3() = default;
  constexpr explicit matrix3(graph& g) : row{components(g), components(g), components(g)} {}
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    for (auto& each : self.row) visit(each);
  }

  constexpr expression& operator()(int i, int j) { return row[i][j]; }
  constexpr const expression& operator()(int i, int j) const { return row[i][j]; }
  constexpr components column(int j) const { return {row[0][j], row[1][j], row[2][j]}; }
  constexpr bool is_constant() const {
    return row[0].is_constant() && row[1].is_constant() && row[2].is_constant();
  }
  constexpr bool is_identity() const {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (i == j ? !row[i][j].is_one() : !row[i][j].is_zero()) return false;
    return true;
  }
};

constexpr components operator*(const matrix3& a, const components& v) {
  return {dot(a.row[0], v), dot(a.row[1], v), dot(a.row[2], v)};
}

constexpr matrix3 transpose(const matrix3& a) {
  matrix3 t;
  for (int i = 0; i < 3; ++i) t.row[i] = a.column(i);
  return t;
}

constexpr matrix3 operator*(const matrix3& a, const matrix3& b) {
  const matrix3 columns = transpose(b);
  matrix3 product;
  for (int i = 0; i < 3; ++i)
    product.row[i] = {dot(a.row[i], columns.row[0]), dot(a.row[i], columns.row[1]),
                      dot(a.row[i], columns.row[2])};
  return product;
}

} // namespace kanexpr::mechanics
