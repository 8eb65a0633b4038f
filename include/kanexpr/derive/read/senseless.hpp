#pragma once

#include <kanexpr/base/problem.hpp>
#include <kanexpr/describe/record.hpp>

/// Steps of an expression that the kinds of their operands do not allow, such as the sine of a vector.
namespace kanexpr::deriving {

using describe::shape;

/// Whether a step may be taken with one operand.
constexpr bool makes_sense(const describe::token& t, shape a) {
  const bool of_vectors = t.what == describe::word::magnitude || t.what == describe::word::normalized;
  return a == (of_vectors ? shape::vector : shape::scalar);
}

/// Whether a step may be taken with two operands.
constexpr bool makes_sense(const describe::token& t, shape a, shape b) {
  using describe::word;
  switch (t.what) {
  case word::add:
  case word::subtract: return a == b;
  case word::multiply: return a == shape::scalar;
  case word::divide: return b == shape::scalar;
  case word::dot: return b == shape::vector && a != shape::scalar;
  case word::cross:
  case word::outer: return a == shape::vector && b == shape::vector;
  case word::scalar_function: return a == shape::scalar && b == shape::scalar;
  case word::number:
  case word::symbol:
  case word::basis:
  case word::negate:
  case word::magnitude:
  case word::normalized:
  case word::position:
  case word::velocity:
  case word::acceleration:
  case word::angular_velocity:
  case word::angular_acceleration:
  case word::derivative:
  case word::partial:
  case word::in_axes:
  case word::misused: break; // do not have two operands
  }
  return false;
}

constexpr std::string_view a_kind(shape s) {
  return s == shape::scalar ? "a scalar" : s == shape::vector ? "a vector" : "a dyadic";
}

constexpr mechanics::problem senseless(const describe::token& t, shape a, std::string_view part,
                                       std::string_view whom) {
  using describe::word;
  if (t.what == word::magnitude)
    return mechanics::sentence(
        {part, whom, " takes the magnitude of ", a_kind(a), a == shape::scalar ? "; write abs" : ""});
  if (t.what == word::normalized) return mechanics::sentence({part, whom, " normalizes ", a_kind(a)});
  return mechanics::sentence(
      {part, whom, " takes ", symbolic::function_name(t.operation), " of ", a_kind(a)});
}

constexpr mechanics::problem senseless(const describe::token& t, shape a, shape b, std::string_view part,
                                       std::string_view whom) {
  using describe::word;
  const auto say = [&](std::string_view does, std::string_view joint, std::string_view hint = "") {
    return mechanics::sentence({part, whom, does, a_kind(a), joint, a_kind(b), hint});
  };
  if (t.what == word::add) return say(" adds ", " and ");
  if (t.what == word::subtract) return say(" subtracts or equates ", " and ");
  if (t.what == word::multiply) return say(" multiplies ", " by ", "; write dot, cross or outer");
  if (t.what == word::divide) return say(" divides ", " by ");
  if (t.what == word::dot)
    return say(" takes the dot product of ", " and ",
               a == shape::scalar && b == shape::scalar ? "; write *" : "");
  if (t.what == word::cross) return say(" takes the cross product of ", " and ");
  if (t.what == word::outer) return say(" takes the outer product of ", " and ");
  if (t.operation == symbolic::operation::atan2) return say(" takes atan2 of ", " and ");
  return say(" raises ", " to the power of ",
             a == shape::vector && b == shape::scalar ? "; write dot(v, v)" : "");
}

} // namespace kanexpr::deriving
