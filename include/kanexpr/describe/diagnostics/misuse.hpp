#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <string_view>

namespace kanexpr::describe {

/// Constructs that C++ allows but that have no meaning in a model.
enum class misuse : unsigned char {
  assignment,
  change,
  caret,
  remainder,
  negation,
  logical_operator,
  comparison,
  unsupported_operator,
  boolean,
  character,
  inner_equation,
  rate,
  derivative_without_frame,
  scalar_derivative_in_frame,
  axes,
  partial,
  function,
  points,
  motion_in_frame,
  zero_factor,
  zero_power,
  index,
  arguments,
  operands,
  coupling,
  self_coupling,
  parallel,
  negative_length,
  zero,
  no_joint,
  no_such_coordinate,
  no_such_speed,
  gear_arguments,
  belt_arguments,
  rack_arguments,
  rod_arguments,
  coincident_arguments,
  parallel_arguments,
  same_axes_arguments,
  rolling_arguments,
  touch_arguments,
};

namespace detail {

/// A function, because a constant would be evaluated in every file.
constexpr base::sentence unknown_function_message() {
  base::sentence p;
  const auto append = [&](std::string_view text) {
    for (char letter : text) p.letters[p.length++] = letter;
  };
  append(" uses an unsupported function; models support ");
  for (const symbolic::function_properties& f : symbolic::functions) append(f.name), append(", ");
  for (const symbolic::binary_function_properties& f : symbolic::binary_functions)
    append(f.name), append(", ");
  append("pow, hypot, min, max and clamp");
  return p;
}

constexpr std::string_view text_of(misuse what) {
  switch (what) {
  case misuse::assignment: return " uses =; write equations with ==";
  case misuse::change: return " uses an operator that modifies a symbol, such as +=";
  case misuse::caret: return " uses ^; write pow(x, n) for a power";
  case misuse::remainder: return " uses %; models have no remainder operator";
  case misuse::negation: return " uses !; a model contains numbers and vectors, not truth values";
  case misuse::logical_operator: return " uses && or ||; list equations separately, with commas between them";
  case misuse::comparison: return " uses !=, <, >, <= or >=; models have only equations, written with ==";
  case misuse::index: return " uses [ ]; the quantities of a model have no entries";
  case misuse::arguments:
    return " calls an expression like a function, as in q(t); write q, and products with *";
  case misuse::operands: return " calls dot or cross with more than two arguments";
  case misuse::coupling:
    return " couples something other than two joints that each turn about one axis or slide along one";
  case misuse::self_coupling: return " couples a joint with itself";
  case misuse::parallel:
    return " keeps a direction parallel to something other than an axis of a frame; write parallel<A::z, "
           "B::z>";
  case misuse::negative_length: return " contains a negative radius or length";
  case misuse::zero:
    return " contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or rational<1, 2>, or "
           "0.0 if you mean zero";
  case misuse::no_joint: return " uses q_of or u_of with something that is neither a joint nor a beam";
  case misuse::no_such_coordinate: return " uses q_of for a coordinate that the joint or beam does not have";
  case misuse::no_such_speed: return " uses u_of for a speed that the joint or beam does not have";
  case misuse::gear_arguments: return " has too few or too many arguments; write gear<Joint, Other, ratio>";
  case misuse::belt_arguments:
    return " has too few or too many arguments; write belt<Joint, Other, radius, other radius>";
  case misuse::rack_arguments:
    return " has too few or too many arguments; write rack_and_pinion<Rack, Pinion, radius>";
  case misuse::rod_arguments:
    return " has too few or too many arguments; write rod_of_length<Point, Other, length>";
  case misuse::coincident_arguments: return " lacks a point; write coincident<Point, Other, directions>";
  case misuse::parallel_arguments:
    return " has too few or too many arguments; write parallel<direction, axis of a frame>";
  case misuse::same_axes_arguments: return " lacks a frame; write same_axes<Frame, Other>";
  case misuse::rolling_arguments:
    return " has too few or too many arguments; write rolls_on<Wheel, Ground, axis, radius>";
  case misuse::touch_arguments:
    return " has too few or too many arguments; write touches<Wheel, Ground, axis, radius>";
  case misuse::unsupported_operator: return " uses an unsupported operator";
  case misuse::boolean: return " contains true or false, which is not a number";
  case misuse::character: return " contains a quoted character, which is not a number";
  case misuse::inner_equation:
    return " contains == inside an expression; use it only once, at the outermost level";
  case misuse::rate:
    return " applies dot to something that is not a coordinate, speed or prescribed quantity";
  case misuse::derivative_without_frame:
    return " takes the derivative of a vector without a frame; write derivative_in<frame>(vector)";
  case misuse::scalar_derivative_in_frame:
    return " takes the derivative of a scalar in a frame; write derivative(scalar)";
  case misuse::axes:
    return " uses in_axes_of with something other than a vector and a frame; write in_axes_of<frame>(vector)";
  case misuse::partial: return " takes a partial derivative with respect to something that is not a symbol";
  case misuse::function: break;
  case misuse::points:
    return " uses position_of with something other than two points; write position_of<point, from>";
  case misuse::motion_in_frame:
    return " names an extra frame or point; motions are relative to the inertial frame: velocity_of<point>";
  case misuse::zero_factor:
    return " contains the factor 0, which is also the value of 1/2 in C++; write q/2 or rational<1, 2>*q, or "
           "0.0 if you mean zero";
  case misuse::zero_power:
    return " contains the exponent 0, which is also the value of 1/2 in C++; write pow(x, 0.5)";
  }
  return {};
}

} // namespace detail

/// The end of a sentence whose subject is the part of the model that contains the misuse.
constexpr base::sentence misuse_message(misuse what) {
  if (what == misuse::function) return detail::unknown_function_message();
  return base::sentence({detail::text_of(what)});
}

} // namespace kanexpr::describe
