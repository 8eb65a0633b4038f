#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include <string_view>

/// The operations of a phrase: the kinds of operands that they accept, and their results.
namespace kanexpr::derivation {

using describe::shape;

/// Whether a step accepts this operand.
constexpr bool accepts(const describe::token& t, shape a) {
  const bool of_vectors =
      t.what == describe::token_kind::magnitude || t.what == describe::token_kind::normalized;
  return a == (of_vectors ? shape::vector : shape::scalar);
}

/// Whether a step accepts these two operands.
constexpr bool accepts(const describe::token& t, shape a, shape b) {
  using describe::token_kind;
  if (t.what == token_kind::add || t.what == token_kind::subtract) return a == b;
  if (t.what == token_kind::multiply) return a == shape::scalar;
  if (t.what == token_kind::divide) return b == shape::scalar;
  if (t.what == token_kind::dot) return b == shape::vector && a != shape::scalar;
  const bool of_vectors = t.what == token_kind::cross || t.what == token_kind::outer;
  return a == b && a == (of_vectors ? shape::vector : shape::scalar);
}

constexpr std::string_view a_kind(shape s) {
  return s == shape::scalar ? "a scalar" : s == shape::vector ? "a vector" : "a dyadic";
}

/// Reports operands that a step does not accept.
constexpr base::sentence operand_mistake(const describe::token& t, shape a, std::string_view part,
                                         std::string_view whom) {
  using describe::token_kind;
  if (t.what == token_kind::magnitude)
    return base::sentence(
        {part, whom, " takes the magnitude of ", a_kind(a), a == shape::scalar ? "; write abs" : ""});
  if (t.what == token_kind::normalized) return base::sentence({part, whom, " normalizes ", a_kind(a)});
  return base::sentence({part, whom, " applies ", symbolic::function_name(t.operation), " to ", a_kind(a)});
}

constexpr base::sentence operand_mistake(const describe::token& t, shape a, shape b, std::string_view part,
                                         std::string_view whom) {
  using describe::token_kind;
  const auto say = [&](std::string_view does, std::string_view joint, std::string_view hint = "") {
    return base::sentence({part, whom, does, a_kind(a), joint, a_kind(b), hint});
  };
  if (t.what == token_kind::add) return say(" adds ", " and ");
  if (t.what == token_kind::subtract) return say(" subtracts or equates ", " and ");
  if (t.what == token_kind::multiply) return say(" multiplies ", " by ", "; write dot, cross or outer");
  if (t.what == token_kind::divide) return say(" divides ", " by ");
  if (t.what == token_kind::dot)
    return say(" takes the dot product of ", " and ",
               a == shape::scalar && b == shape::scalar ? "; write *" : "");
  if (t.what == token_kind::cross) return say(" takes the cross product of ", " and ");
  if (t.what == token_kind::outer) return say(" takes the outer product of ", " and ");
  if (symbolic::is_binary_function(t.operation))
    return base::sentence({part, whom, " applies ", symbolic::function_name(t.operation), " to ", a_kind(a),
                           " and ", a_kind(b)});
  return say(" raises ", " to the power of ",
             a == shape::vector && b == shape::scalar ? "; write dot(v, v)" : "");
}

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

/// Combines a vector, the last value, with the one before it.
constexpr bool combine_with_vector(const describe::token& t, sequence<value>& stack) {
  using describe::token_kind;
  value &a = stack[stack.size() - 2], &b = stack.back();
  if (t.what == token_kind::add && a.kind == shape::vector) {
    a.vector.add(b.vector);
  } else if (t.what == token_kind::multiply && a.kind == shape::scalar) {
    for (mechanics::vector::part& p : b.vector.parts) p.value = mechanics::scaled(a.scalar, p.value);
    a.kind = shape::vector;
    a.vector = static_cast<mechanics::vector&&>(b.vector);
  } else {
    return false;
  }
  stack.pop();
  return true;
}

/// Sums, products and quotients of scalars, and sums and multiples of vectors, the most frequent operations,
/// without moving their values. Returns whether the step is one of them.
constexpr bool combine_in_place(const describe::token& t, sequence<value>& stack) {
  using describe::token_kind;
  if (t.what < token_kind::add || t.what > token_kind::divide) return false;
  if (stack.back().kind == shape::vector) return combine_with_vector(t, stack);
  value& a = stack[stack.size() - 2];
  const expression b = stack.back().scalar;
  if (a.kind != shape::scalar || stack.back().kind != shape::scalar) return false;
  if (t.what == token_kind::divide && b.is_zero()) return false;
  stack.pop();
  if (t.what == token_kind::multiply)
    a.scalar *= b;
  else if (t.what == token_kind::add)
    a.scalar += b;
  else
    a.scalar = t.what == token_kind::subtract ? a.scalar + -b : a.scalar / b;
  return true;
}

constexpr value transformed(const mechanics::mechanism& m, const describe::token& t, const value& a) {
  using describe::token_kind;
  if (t.what == token_kind::magnitude) return value::of(sqrt(dot(m, a.vector, a.vector)));
  if (t.what == token_kind::normalized) return value::of(normalized(m, a.vector));
  return value::of(symbolic::apply(t.operation, a.scalar));
}

} // namespace kanexpr::derivation
