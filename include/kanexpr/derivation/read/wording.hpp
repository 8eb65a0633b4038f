#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Names for the parts of a model, for use in messages.
namespace kanexpr::derivation {

using describe::frame_record;
using describe::load_record;
using describe::phrase;
using describe::shape;
using describe::symbol_record;

constexpr std::string_view kind_of(const symbol_record& s) {
  using symbolic::symbol_kind;
  switch (s.kind) {
  case symbol_kind::time: return "time ";
  case symbol_kind::coordinate: return "coordinate ";
  case symbol_kind::speed: return s.order == describe::of_state_variable ? "state variable " : "speed ";
  case symbol_kind::parameter: return "parameter ";
  case symbol_kind::input: return s.order == describe::unprescribed ? "input " : "prescribed quantity ";
  case symbol_kind::coordinate_rate: return "the rate of coordinate ";
  case symbol_kind::speed_rate:
    return s.order == describe::of_state_variable ? "the rate of state variable " : "the rate of speed ";
  case symbol_kind::auxiliary_speed: return "auxiliary speed ";
  case symbol_kind::multiplier: return "multiplier ";
  case symbol_kind::weight: return "weight ";
  case symbol_kind::direction: return "direction ";
  }
  return "";
}

/// A symbol, point or frame that identifies the phrase in which it appears.
constexpr std::string_view name_in(const phrase& p) {
  for (const describe::token& t : p)
    if (t.symbol != nullptr) return t.symbol->called.view();
  for (const describe::token& t : p)
    if (t.point != nullptr) return t.point->called;
  for (const describe::token& t : p)
    if (t.frame != nullptr) return t.frame->called;
  return "";
}

/// The name of a type; arguments that are too long for a message are omitted: `particle<...>`.
constexpr base::sentence short_name(std::string_view called) {
  constexpr std::size_t longest = 40;
  if (called.size() <= longest) return base::sentence({called});
  return base::sentence({called.substr(0, called.find('<')), "<...>"});
}

/// The number of operands that a token takes from those before it.
constexpr int operands_of(const describe::token& t) {
  using describe::token_kind;
  switch (t.what) {
  case token_kind::add:
  case token_kind::subtract:
  case token_kind::multiply:
  case token_kind::divide:
  case token_kind::dot:
  case token_kind::cross:
  case token_kind::outer: return 2;
  case token_kind::negate:
  case token_kind::magnitude:
  case token_kind::normalized:
  case token_kind::derivative:
  case token_kind::partial:
  case token_kind::in_axes:
  case token_kind::length:
  case token_kind::wheel_axis: return 1;
  case token_kind::scalar_function: return symbolic::is_binary(t.operation) ? 2 : 1;
  case token_kind::composed:
  case token_kind::external: return static_cast<int>(t.number.numerator);
  case token_kind::number:
  case token_kind::symbol:
  case token_kind::basis:
  case token_kind::position:
  case token_kind::velocity:
  case token_kind::acceleration:
  case token_kind::angular_velocity:
  case token_kind::angular_acceleration:
  case token_kind::of_load:
  case token_kind::misused: return 0;
  }
  return 0;
}

/// Whether tokens in postfix order form a single expression.
constexpr bool is_whole(const phrase& p) {
  int depth = 0;
  for (const describe::token& t : p) {
    const int operands = operands_of(t);
    if (depth < operands) return false;
    depth += 1 - operands;
  }
  return depth == 1;
}

/// Returns the subject of messages about a load: "the force at P", "the spring between P and Q", "the
/// potential energy with q1".
constexpr base::sentence name_of(const load_record& r) {
  if (r.muscle != nullptr) return base::sentence({r.word, " ", r.called});
  if (r.other_point != nullptr)
    return base::sentence({r.word, " between ", r.point->called, " and ", r.other_point->called});
  if (r.point != nullptr) return base::sentence({r.word, " at ", r.point->called});
  if (r.other_frame != nullptr)
    return base::sentence({r.word, " between ", r.frame->called, " and ", r.other_frame->called});
  if (r.frame != nullptr) return base::sentence({r.word, " on ", r.frame->called});
  const std::string_view held = name_in(r.known_by);
  return base::sentence({r.word.empty() ? r.called : r.word, held.empty() ? "" : " with ", held});
}

/// The lists in which a name of a model may appear; each name has a single meaning.
enum class symbol_list : unsigned char {
  coordinates,
  rates_of_coordinates,
  speeds,
  state_variables,
  auxiliary_speeds,
  values,
  parameters,
  inputs,
  times,
};

/// Returns the name of the list as it appears in error messages.
constexpr std::string_view called(symbol_list list) {
  switch (list) {
  case symbol_list::coordinates: return "coordinates";
  case symbol_list::rates_of_coordinates: return "rates of coordinates";
  case symbol_list::speeds: return "speeds";
  case symbol_list::state_variables: return "state variables";
  case symbol_list::auxiliary_speeds: return "auxiliary speeds";
  case symbol_list::values: return "values";
  case symbol_list::parameters: return "parameters";
  case symbol_list::inputs: return "inputs";
  case symbol_list::times: return "symbols for the time";
  }
  return {};
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
