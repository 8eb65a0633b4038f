#pragma once

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// The operations of a phrase on operands of the right kinds (senseless.hpp).
namespace kanexpr::derivation {

constexpr value combined(const mechanics::mechanism& m, const describe::token& t, const value& a,
                         const value& b) {
  using describe::shape;
  using describe::token_kind;
  switch (t.what) {
  case token_kind::add: return sum(a, b);
  case token_kind::subtract: return sum(a, negative(m, b));
  case token_kind::multiply: return scaled(a.scalar, b);
  case token_kind::divide:
    if (a.kind == shape::scalar) return value::of(a.scalar / b.scalar);
    return scaled(1 / b.scalar, a);
  case token_kind::dot:
    if (a.kind == shape::dyadic) return value::of(dot(m, a.dyadic, b.vector));
    return value::of(dot(m, a.vector, b.vector));
  case token_kind::cross: return value::of(cross(m, a.vector, b.vector));
  case token_kind::outer: return value::of(outer(m, a.vector, b.vector));
  default: return value::of({*m.g, symbolic::build(*m.g, t.operation, a.scalar.node(), b.scalar.node())});
  }
}

constexpr value transformed(const mechanics::mechanism& m, const describe::token& t, const value& a) {
  using describe::token_kind;
  if (t.what == token_kind::magnitude) return value::of(sqrt(dot(m, a.vector, a.vector)));
  if (t.what == token_kind::normalized) return value::of(normalized(m, a.vector));
  return value::of(symbolic::apply(t.operation, a.scalar));
}

} // namespace kanexpr::derivation
