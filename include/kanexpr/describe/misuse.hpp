#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::describe {

/// What C++ lets a person write and a model gives no meaning.
enum class misuse : unsigned char {
  assignment,
  change,
  caret,
  remainder,
  denial,
  junction,
  comparison,
  bits,
  truth,
  letter,
  inner_equation,
  rate,
  unseen_derivative,
  seen_scalar,
  axes,
  partial,
  function,
  points,
  seen_motion,
  zero_factor,
  zero_power,
  index,
  arguments,
  operands,
  coupling,
  own_coupling,
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

inline constexpr mechanics::sentence which_functions_there_are = [] {
  mechanics::sentence p; // written letter by letter, since each file that includes this header forms it
  const auto append = [&](std::string_view text) {
    for (char letter : text) p.letters[p.length++] = letter;
  };
  append(" is written with a function that models do not have; those they have are ");
  for (const symbolic::function_properties& f : symbolic::functions) append(f.name), append(", ");
  append("atan2, pow, hypot, min, max and clamp");
  return p;
}();

/// How a sentence about a part of a model goes on that holds it.
constexpr std::string_view what_is_wrong(misuse what) {
  switch (what) {
  case misuse::assignment: return " is written with =; an equation is written with ==";
  case misuse::change: return " is written with an operator that changes a symbol, such as +=";
  case misuse::caret: return " is written with ^; a power is written pow(x, n)";
  case misuse::remainder: return " is written with %; models have no remainders";
  case misuse::denial: return " is written with !; a model holds numbers and vectors, not truth values";
  case misuse::junction: return " is written with && or ||; equations are written one by one, between commas";
  case misuse::comparison: return " is written with !=, <, >, <= or >=; models have equations only, with ==";
  case misuse::index: return " is written with [ ]; what a model holds has no entries";
  case misuse::arguments:
    return " is written with arguments, as in q(t); symbols are written alone, and products with *";
  case misuse::operands: return " takes a product of more than two vectors at once";
  case misuse::coupling:
    return " couples something other than two joints that each turn about one axis or slide along one";
  case misuse::own_coupling: return " couples a joint with itself";
  case misuse::parallel:
    return " keeps a direction parallel to something other than an axis of a frame: parallel<A::z, B::z>";
  case misuse::negative_length: return " holds a radius or length below zero";
  case misuse::zero:
    return " holds the number 0, which is what 1/2 is in C++; write 0.5 or rational<1, 2>, and 0.0 for a "
           "zero "
           "that is meant";
  case misuse::no_joint: return " asks q_of or u_of for a symbol of something that is not a joint";
  case misuse::no_such_coordinate: return " asks q_of for a coordinate that the joint does not have";
  case misuse::no_such_speed: return " asks u_of for a speed that the joint does not have";
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
  case misuse::bits: return " is written with an operator that models do not have";
  case misuse::truth: return " holds true or false, which is not a number";
  case misuse::letter: return " holds a letter in quotes, which is not a number";
  case misuse::inner_equation: return " holds == inside an expression; write it once, outermost";
  case misuse::rate: return " takes dot of something that is not a coordinate, speed or prescribed quantity";
  case misuse::unseen_derivative:
    return " takes the derivative of a vector, and not as a frame sees it; write "
           "derivative_in<frame>(vector)";
  case misuse::seen_scalar:
    return " takes the derivative of a scalar as a frame sees it; write derivative(scalar)";
  case misuse::axes:
    return " uses in_axes_of for something other than a vector and a frame: in_axes_of<frame>(vector)";
  case misuse::partial: return " takes a partial derivative by something that is not a symbol";
  case misuse::function: return which_functions_there_are.view();
  case misuse::points:
    return " uses position_of for something other than two points: position_of<point, from>";
  case misuse::seen_motion:
    return " names a frame or point too many: motions are those in the inertial frame, velocity_of<point>";
  case misuse::zero_factor:
    return " holds the factor 0, which is what 1/2 is in C++; write q/2 or rational<1, 2>*q, and 0.0 for a "
           "zero that is meant";
  case misuse::zero_power: return " holds a power of 0, which is what 1/2 is in C++; write pow(x, 0.5)";
  }
  return "";
}

} // namespace kanexpr::describe
