#pragma once

#include <kanexpr/base/equal.hpp>

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
  power, ///< general exponents only; integer powers become products, and half powers become square roots
  // functions of one argument, up to `last_function`; `functions` lists their properties
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2, ///< has two arguments
  exp,
  log,
  sinh,
  cosh,
  tanh,
  abs,
  sign,
  cbrt,
  erf,
  wrap_to_pi,
  // further functions of two arguments; `binary_functions` lists their properties
  // selections: the second operand if the first is positive (or not positive), otherwise zero
  if_positive,
  if_not_positive,
  // lists, linear systems and calls; a list is not a value, only an operand of these
  pair, ///< a list: its first element and the list of the remaining elements, terminated by the constant zero
  factorization, ///< factorization of the matrix given as a list of rows, each of them a list; the constant b
                 ///< is its order
  solve,         ///< A x = b: a factorization and the list b
  transposed_solve,    ///< Aᵀ x = b
  component,           ///< an element of a solution; the constant b is its zero-based index
  singularity_measure, ///< distance of a factorization from singularity: the determinant if small, otherwise
                       ///< the pivots relative to the list b, the squared sizes of the entries
  call,            ///< call to a user-defined function with a list of operands; the constant b is its index
  symmetric_solve, ///< M X = B: the factors of M = LᵀDL and the matrix b, both as lists of rows
};

constexpr bool is_leaf(operation op) { return op == operation::constant || op == operation::symbol; }

inline constexpr operation last_function = operation::wrap_to_pi;

constexpr bool is_binary(operation op) {
  return (op >= operation::add && op <= operation::power) || op == operation::atan2 || op > last_function;
}
/// Whether the second operand is a plain number (an order or an index), not a value.
constexpr bool has_index_operand(operation op) {
  return op == operation::factorization || op == operation::component || op == operation::call;
}

/// Whether the operation is the solution of a linear system, whose elements are its components.
constexpr bool is_solution(operation op) {
  return op == operation::solve || op == operation::transposed_solve;
}

constexpr bool is_selection(operation op) {
  return op == operation::if_positive || op == operation::if_not_positive;
}

/// The second operand if the selection passes it, otherwise zero. If the condition is NaN, the result is NaN.
constexpr double selected(operation op, double condition, double x) {
  if (!base::is_number(condition)) return condition;
  return (condition > 0) == (op == operation::if_positive) ? x : 0;
}

constexpr bool is_commutative(operation op) { return op == operation::add || op == operation::multiply; }

/// Whether the operation is a function of one argument.
constexpr bool is_function(operation op) {
  return op >= operation::sqrt && op <= last_function && op != operation::atan2;
}

/// Whether the operation is a function of two arguments; powers and selections are not.
constexpr bool is_binary_function(operation op) {
  return op == operation::atan2 || (op > last_function && op < operation::if_positive);
}

/// The forms of operations; all functions of one argument have the same form, and so do all functions of two.
/// Code that treats these functions alike switches over forms, so that adding a function does not affect it.
enum class form : unsigned char {
  leaf, ///< a constant or a symbol
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  function,
  binary_function,
  selection,
  list_operation, ///< a list, a part of a linear system or a call, from `pair` on
};

constexpr form form_of(operation op) {
  if (op >= operation::pair) return form::list_operation;
  if (op >= operation::if_positive) return form::selection;
  if (op > operation::power) return is_binary_function(op) ? form::binary_function : form::function;
  return op <= operation::symbol ? form::leaf : static_cast<form>(static_cast<int>(op) - 1);
}
static_assert(form_of(operation::negate) == form::negate && form_of(operation::power) == form::power);

} // namespace kanexpr::symbolic
