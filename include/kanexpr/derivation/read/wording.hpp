#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Names for the parts of a model, for use in sentences.
namespace kanexpr::derivation {

using describe::frame_record;
using describe::phrase;
using describe::shape;
using describe::symbol_record;

constexpr std::string_view kind_of(const symbol_record& s) {
  using symbolic::symbol_kind;
  switch (s.kind) {
  case symbol_kind::time: return "time ";
  case symbol_kind::coordinate: return "coordinate ";
  case symbol_kind::speed: return "speed ";
  case symbol_kind::parameter: return "parameter ";
  case symbol_kind::input: return s.order == describe::unprescribed ? "input " : "prescribed quantity ";
  case symbol_kind::coordinate_rate: return "the rate of coordinate ";
  case symbol_kind::speed_rate: return "the rate of speed ";
  case symbol_kind::auxiliary_speed: return "auxiliary speed ";
  case symbol_kind::multiplier: return "multiplier ";
  case symbol_kind::weight: return "weight ";
  case symbol_kind::direction: return "direction ";
  }
  return "";
}

/// A symbol, point or frame in a phrase, to identify the phrase.
constexpr std::string_view name_in(const phrase& p) {
  for (int i = 0; i < p.size; ++i)
    if (p.tokens[i].symbol != nullptr) return p.tokens[i].symbol->called.view();
  for (int i = 0; i < p.size; ++i)
    if (p.tokens[i].point != nullptr) return p.tokens[i].point->called;
  for (int i = 0; i < p.size; ++i)
    if (p.tokens[i].frame != nullptr) return p.tokens[i].frame->called;
  return "";
}

/// The name of a type, without arguments that are too long for a sentence: `particle<...>`.
constexpr base::sentence short_name(std::string_view called) {
  constexpr std::size_t longest = 40;
  if (called.size() <= longest) return base::sentence({called});
  return base::sentence({called.substr(0, called.find('<')), "<...>"});
}

/// Whether tokens in postfix order form a single expression.
constexpr bool is_whole(const phrase& p) {
  using describe::token_kind;
  int depth = 0;
  for (int i = 0; i < p.size; ++i) {
    int operands = 0;
    switch (p.tokens[i].what) {
    case token_kind::add:
    case token_kind::subtract:
    case token_kind::multiply:
    case token_kind::divide:
    case token_kind::dot:
    case token_kind::cross:
    case token_kind::outer: operands = 2; break;
    case token_kind::scalar_function: operands = symbolic::is_binary(p.tokens[i].operation) ? 2 : 1; break;
    case token_kind::composed:
    case token_kind::external: operands = static_cast<int>(p.tokens[i].number.numerator); break;
    case token_kind::negate:
    case token_kind::magnitude:
    case token_kind::normalized:
    case token_kind::derivative:
    case token_kind::partial:
    case token_kind::in_axes:
    case token_kind::length:
    case token_kind::wheel_axis: operands = 1; break;
    case token_kind::number:
    case token_kind::symbol:
    case token_kind::basis:
    case token_kind::position:
    case token_kind::velocity:
    case token_kind::acceleration:
    case token_kind::angular_velocity:
    case token_kind::angular_acceleration:
    case token_kind::misused: break;
    }
    if (depth < operands) return false;
    depth += 1 - operands;
  }
  return depth == 1;
}

constexpr std::string_view is_a(shape kind) {
  switch (kind) {
  case shape::scalar: return " is a scalar; ";
  case shape::vector: return " is a vector; ";
  case shape::dyadic: return " is a dyadic; ";
  case shape::equation: return " is an equation; ";
  case shape::vanishing: return " is a constraint; ";
  case shape::kinematics:
  case shape::simple: return " is a list of kinematic differential equations; ";
  case shape::nothing:
  case shape::foreign: break;
  }
  return " is not an expression; ";
}

} // namespace kanexpr::derivation
