#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>

#include <limits>

namespace kanexpr::symbolic {

/// The operation that a node applies to its operands.
enum class operation : unsigned char {
  constant,
  symbol,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power, ///< general exponents only; integer powers become products, half powers square roots
  // functions of one argument, and atan2; `functions` lists their properties
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  sinh,
  cosh,
  tanh,
  abs,
  sign,
  // selections: the second operand if the first is positive (or not positive), otherwise zero
  if_positive,
  if_not_positive,
  // lists, linear systems and calls; a list is not a value, only an operand of these
  pair,          ///< a list: its first element and the list of the rest, ended by the constant zero
  factorization, ///< factorization of the matrix given as a list of rows, each of them a list; the constant b
                 ///< is its order
  solve,         ///< A x = b: a factorization and the list b
  transposed_solve,    ///< Aᵀ x = b
  component,           ///< an element of a solution; the constant b is its zero-based index
  singularity_measure, ///< distance of a factorization from singularity: the determinant if small, otherwise
                       ///< the pivots relative to the list b, the squared sizes of the entries
  call, ///< call of a user-defined function with a list of operands; the constant b is its index
};

constexpr bool is_leaf(operation op) { return op == operation::constant || op == operation::symbol; }

constexpr bool is_binary(operation op) {
  return (op >= operation::add && op <= operation::power) || op == operation::atan2 ||
         op >= operation::if_positive;
}
/// Whether the second operand is a plain number (an order or an index), not a value.
constexpr bool is_numbered(operation op) {
  return op == operation::factorization || op == operation::component || op == operation::call;
}

constexpr bool is_selection(operation op) {
  return op == operation::if_positive || op == operation::if_not_positive;
}

/// The second operand if the selection passes it, otherwise zero. If the condition is NaN, the result is NaN.
constexpr double selected(operation op, double condition, double x) {
  if (!numeric::is_number(condition)) return condition;
  return (condition > 0) == (op == operation::if_positive) ? x : 0;
}

constexpr bool is_commutative(operation op) { return op == operation::add || op == operation::multiply; }

/// Whether the operation is a function of one argument, except atan2.
constexpr bool is_function(operation op) {
  return op >= operation::sqrt && op <= operation::sign && op != operation::atan2;
}

/// The forms of operations; all functions of one argument have the same form. Code that treats these
/// functions alike switches over forms, so that adding a function does not affect it.
enum class form : unsigned char {
  constant,
  symbol,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  function,
  atan2,
  selection,
  pair,
  factorization,
  solve,
  transposed_solve,
  component,
  singularity_measure,
  call,
};

constexpr form form_of(operation op) {
  if (op <= operation::power) return static_cast<form>(op);
  if (op < operation::if_positive) return op == operation::atan2 ? form::atan2 : form::function;
  if (op < operation::pair) return form::selection;
  constexpr int before = static_cast<int>(operation::pair) - static_cast<int>(form::pair);
  return static_cast<form>(static_cast<int>(op) - before);
}
static_assert(form_of(operation::power) == form::power && form_of(operation::call) == form::call);

/// The symmetry of a function: f(-x) is -f(x) if odd, f(x) if even.
enum class parity { none, odd, even };

/// The unit of a function's value, given the unit of its argument.
enum class unit_rule {
  numbers, ///< dimensionless, for a dimensionless argument
  kept,    ///< the same unit
  root,    ///< the square root of the unit
  dropped, ///< dimensionless, for any argument
};

/// The properties of a function of one argument, except its derivative (functions.hpp). The defaults are safe
/// for every function.
struct function_properties {
  static constexpr double everywhere = (std::numeric_limits<double>::max)(); ///< finite for -ffast-math
  static constexpr int nowhere = -1;

  operation op;
  const char* name;        ///< its name in C++
  double (*value)(double); ///< evaluates the function in constant expressions
  const char* latex = "";  ///< a LaTeX command; if empty, the name as an operator
  parity symmetry = parity::none;
  double smooth_from = -everywhere, smooth_to = everywhere; ///< open interval where differentiable
  int exact_at = nowhere;                                   ///< the integer at which its value is an integer
  unit_rule unit = unit_rule::numbers;
  bool is_trigonometric = false; ///< counted as trigonometric, otherwise as `other`
  bool never_negative = false;
  bool stays_finite = false;    ///< finite if its argument is finite
  bool passes_infinity = false; ///< not finite if its argument is not

  constexpr bool is_smooth_at(double x) const { return x > smooth_from && x < smooth_to; }
};

/// In the order of the operations.
inline constexpr function_properties functions[] = {
    {.op = operation::sqrt,
     .name = "sqrt",
     .value = elementary::sqrt,
     .latex = "\\sqrt",
     .smooth_from = 0,
     .unit = unit_rule::root,
     .never_negative = true,
     .passes_infinity = true},
    {.op = operation::sin,
     .name = "sin",
     .value = elementary::sin,
     .latex = "\\sin",
     .symmetry = parity::odd,
     .exact_at = 0,
     .is_trigonometric = true,
     .stays_finite = true,
     .passes_infinity = true},
    {.op = operation::cos,
     .name = "cos",
     .value = elementary::cos,
     .latex = "\\cos",
     .symmetry = parity::even,
     .exact_at = 0,
     .is_trigonometric = true,
     .stays_finite = true,
     .passes_infinity = true},
    {.op = operation::tan,
     .name = "tan",
     .value = elementary::tan,
     .latex = "\\tan",
     .symmetry = parity::odd,
     .exact_at = 0,
     .is_trigonometric = true,
     .stays_finite = true, // rounding keeps it finite
     .passes_infinity = true},
    {.op = operation::asin,
     .name = "asin",
     .value = elementary::asin,
     .latex = "\\arcsin",
     .symmetry = parity::odd,
     .smooth_from = -1,
     .smooth_to = 1,
     .exact_at = 0,
     .is_trigonometric = true},
    {.op = operation::acos,
     .name = "acos",
     .value = elementary::acos,
     .latex = "\\arccos",
     .smooth_from = -1,
     .smooth_to = 1,
     .exact_at = 1,
     .is_trigonometric = true},
    {.op = operation::atan,
     .name = "atan",
     .value = elementary::atan,
     .latex = "\\arctan",
     .symmetry = parity::odd,
     .exact_at = 0,
     .is_trigonometric = true,
     .stays_finite = true},
    {.op = operation::exp,
     .name = "exp",
     .value = elementary::exp,
     .latex = "\\exp",
     .exact_at = 0,
     .never_negative = true},
    {.op = operation::log,
     .name = "log",
     .value = elementary::log,
     .latex = "\\ln",
     .smooth_from = 0,
     .exact_at = 1},
    {.op = operation::sinh,
     .name = "sinh",
     .value = elementary::sinh,
     .latex = "\\sinh",
     .symmetry = parity::odd,
     .exact_at = 0,
     .passes_infinity = true},
    {.op = operation::cosh,
     .name = "cosh",
     .value = elementary::cosh,
     .latex = "\\cosh",
     .symmetry = parity::even,
     .exact_at = 0,
     .never_negative = true,
     .passes_infinity = true},
    {.op = operation::tanh,
     .name = "tanh",
     .value = elementary::tanh,
     .latex = "\\tanh",
     .symmetry = parity::odd,
     .exact_at = 0,
     .stays_finite = true},
    {.op = operation::abs,
     .name = "abs",
     .value = elementary::abs,
     .symmetry = parity::even,
     .unit = unit_rule::kept,
     .never_negative = true,
     .stays_finite = true,
     .passes_infinity = true},
    {.op = operation::sign,
     .name = "sign",
     .value = elementary::sign,
     .symmetry = parity::odd,
     .unit = unit_rule::dropped,
     .stays_finite = true},
};

namespace detail {

constexpr int place_of_function(operation op) {
  return static_cast<int>(op) - static_cast<int>(operation::sqrt) - (op > operation::atan2 ? 1 : 0);
}

constexpr bool every_function_has_its_place() {
  int place = 0;
  for (const function_properties& f : functions)
    if (!is_function(f.op) || place_of_function(f.op) != place++) return false;
  return place == place_of_function(operation::sign) + 1;
}
static_assert(every_function_has_its_place());

} // namespace detail

/// The properties of a function of one argument.
constexpr const function_properties& properties_of(operation op) {
  return functions[detail::place_of_function(op)];
}

/// The C++ name of the function; empty for arithmetic.
constexpr const char* function_name(operation op) {
  switch (form_of(op)) {
  case form::function: return properties_of(op).name;
  case form::atan2: return "atan2";
  case form::selection: return "if_positive";
  case form::component: return "solve";
  case form::singularity_measure: return "singularity_measure";
  case form::constant:
  case form::symbol:
  case form::negate:
  case form::add:
  case form::subtract:
  case form::multiply:
  case form::divide:
  case form::power:
  case form::pair:
  case form::factorization:
  case form::solve:
  case form::transposed_solve:
  case form::call: return ""; // its name is stored in the graph
  }
  return "";
}

} // namespace kanexpr::symbolic
