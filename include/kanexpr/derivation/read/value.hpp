#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::derivation {

using base::sequence;
using mechanics::components;
using mechanics::matrix3;
using symbolic::expression;
using symbolic::graph;

/// The value of a phrase of a model.
struct value {
  describe::shape kind = describe::shape::nothing;
  expression scalar{};
  mechanics::vector vector{};
  mechanics::dyadic dyadic{};

  static constexpr value of(expression e) {
    value v;
    v.kind = describe::shape::scalar;
    v.scalar = e;
    return v;
  }
  static constexpr value of(mechanics::vector e) {
    value v;
    v.kind = describe::shape::vector;
    v.vector = static_cast<mechanics::vector&&>(e);
    return v;
  }
  static constexpr value of(mechanics::dyadic e) {
    value v;
    v.kind = describe::shape::dyadic;
    v.dyadic = static_cast<mechanics::dyadic&&>(e);
    return v;
  }
};

constexpr mechanics::vector plus(const mechanics::vector& a, const mechanics::vector& b) {
  mechanics::vector sum = a;
  sum.add(b);
  return sum;
}

constexpr value negative(const mechanics::mechanism& m, const value& a) {
  if (a.kind == describe::shape::vector) return value::of(-m.one() * a.vector);
  if (a.kind == describe::shape::dyadic) return value::of(-m.one() * a.dyadic);
  return value::of(-a.scalar);
}

constexpr value sum(const value& a, const value& b) {
  if (a.kind == describe::shape::vector) return value::of(plus(a.vector, b.vector));
  if (a.kind == describe::shape::dyadic) {
    mechanics::dyadic d = a.dyadic;
    d.add(b.dyadic);
    return value::of(d);
  }
  return value::of(a.scalar + b.scalar);
}

constexpr value scaled(expression s, const value& a) {
  if (a.kind == describe::shape::vector) return value::of(s * a.vector);
  if (a.kind == describe::shape::dyadic) return value::of(s * a.dyadic);
  return value::of(s * a.scalar);
}

/// Two vectors in the axes of one frame: the frame deepest in the tree among those that the vectors use.
struct together {
  int frame = mechanics::mechanism::inertial;
  components a{}, b{};
};

constexpr together in_common_axes(const mechanics::mechanism& m, const mechanics::vector& a,
                                  const mechanics::vector& b) {
  together t;
  int depth = -1;
  for (const mechanics::vector* v : {&a, &b})
    for (const mechanics::vector::part& p : v->parts) {
      const int d = mechanics::path::depth(m, p.frame);
      if (d > depth) t.frame = p.frame, depth = d;
    }
  t.a = mechanics::express(m, a, t.frame);
  t.b = mechanics::express(m, b, t.frame);
  return t;
}

/// Returns the component of a vector along a direction. The direction is usually a basis vector, so that only
/// one component, in its axes, is needed.
constexpr expression along(const mechanics::mechanism& m, const mechanics::vector& v,
                           const mechanics::vector& direction) {
  const mechanics::vector::part& d = direction.parts[0];
  return mechanics::dot(mechanics::express(m, v, d.frame), d.value);
}

constexpr expression dot(const mechanics::mechanism& m, const mechanics::vector& a,
                         const mechanics::vector& b) {
  if (a.parts.size() > 1 && b.parts.size() == 1) return along(m, a, b);
  if (b.parts.size() > 1 && a.parts.size() == 1) return along(m, b, a);
  const together t = in_common_axes(m, a, b);
  return mechanics::dot(t.a, t.b);
}

/// Normalizes a vector in the axes of one frame, so that terms cancel before the division.
constexpr mechanics::vector normalized(const mechanics::mechanism& m, const mechanics::vector& v) {
  const together t = in_common_axes(m, v, v);
  mechanics::vector unit;
  unit.add(t.frame, (1 / sqrt(mechanics::dot(t.a, t.a))) * t.a);
  return unit;
}

constexpr mechanics::vector cross(const mechanics::mechanism& m, const mechanics::vector& a,
                                  const mechanics::vector& b) {
  const together t = in_common_axes(m, a, b);
  mechanics::vector v;
  v.add(t.frame, mechanics::cross(t.a, t.b));
  return v;
}

constexpr mechanics::dyadic outer(const mechanics::mechanism& m, const mechanics::vector& a,
                                  const mechanics::vector& b) {
  mechanics::dyadic d;
  for (const mechanics::vector::part& p : a.parts)
    for (const mechanics::vector::part& q : b.parts) {
      matrix3 value(*m.g);
      for (int i = 0; i < 3; ++i) value.row[i] = p.value[i] * q.value;
      d.add(p.frame, q.frame, value);
    }
  return d;
}

constexpr mechanics::vector dot(const mechanics::mechanism& m, const mechanics::dyadic& d,
                                const mechanics::vector& v) {
  mechanics::vector product;
  for (const mechanics::dyadic::part& p : d.parts)
    product.add(p.left, p.value * mechanics::express(m, v, p.right));
  return product;
}

} // namespace kanexpr::derivation
