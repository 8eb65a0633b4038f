#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include <string_view>

/// Steps of an expression whose operands have the wrong kind, such as the sine of a vector.
namespace kanexpr::derivation {

using describe::shape;

/// Whether a step accepts this operand.
constexpr bool makes_sense(const describe::token& t, shape a) {
  const bool of_vectors =
      t.what == describe::token_kind::magnitude || t.what == describe::token_kind::normalized;
  return a == (of_vectors ? shape::vector : shape::scalar);
}

/// Whether a step accepts these two operands.
constexpr bool makes_sense(const describe::token& t, shape a, shape b) {
  using describe::token_kind;
  switch (t.what) {
  case token_kind::add:
  case token_kind::subtract: return a == b;
  case token_kind::multiply: return a == shape::scalar;
  case token_kind::divide: return b == shape::scalar;
  case token_kind::dot: return b == shape::vector && a != shape::scalar;
  case token_kind::cross:
  case token_kind::outer: return a == shape::vector && b == shape::vector;
  case token_kind::scalar_function: return a == shape::scalar && b == shape::scalar;
  case token_kind::number:
  case token_kind::symbol:
  case token_kind::composed:
  case token_kind::external:
  case token_kind::basis:
  case token_kind::negate:
  case token_kind::magnitude:
  case token_kind::normalized:
  case token_kind::position:
  case token_kind::velocity:
  case token_kind::acceleration:
  case token_kind::angular_velocity:
  case token_kind::angular_acceleration:
  case token_kind::derivative:
  case token_kind::partial:
  case token_kind::in_axes:
  case token_kind::length:
  case token_kind::wheel_axis:
  case token_kind::misused: break; // not binary
  }
  return false;
}

constexpr std::string_view a_kind(shape s) {
  return s == shape::scalar ? "a scalar" : s == shape::vector ? "a vector" : "a dyadic";
}

constexpr base::sentence senseless(const describe::token& t, shape a, std::string_view part,
                                   std::string_view whom) {
  using describe::token_kind;
  if (t.what == token_kind::magnitude)
    return base::sentence(
        {part, whom, " takes the magnitude of ", a_kind(a), a == shape::scalar ? "; write abs" : ""});
  if (t.what == token_kind::normalized) return base::sentence({part, whom, " normalizes ", a_kind(a)});
  return base::sentence({part, whom, " applies ", symbolic::function_name(t.operation), " to ", a_kind(a)});
}

constexpr base::sentence senseless(const describe::token& t, shape a, shape b, std::string_view part,
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

} // namespace kanexpr::derivation
