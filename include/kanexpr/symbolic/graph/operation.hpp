#pragma once

namespace kanexpr::symbolic {

/// What a node of the graph does with its operands.
enum class operation : unsigned char {
  constant,
  symbol,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power, ///< general exponents only; integer powers are products, halves are square roots
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
  abs,
  sign,
  // linear systems; lists are no values, and stand only as operands of these
  pair,             ///< a list: its first element and the list of the others, ended by the constant zero
  factorization,    ///< of the matrix with a list of rows, each a list, and of the order in the constant b
  solve,            ///< A x = b: a factorization and the list b
  transposed_solve, ///< Aᵀ x = b
  component,        ///< an element of a solution; the constant b counts from zero
  regularity,       ///< how far a factorization is from a singular matrix: of a small one its determinant, of
                    ///< another its pivots beside the list b, squares of the sizes of its entries
};

constexpr bool is_leaf(operation op) { return op == operation::constant || op == operation::symbol; }

constexpr bool is_binary(operation op) {
  return (op >= operation::add && op <= operation::power) || op == operation::atan2 || op >= operation::pair;
}
/// Whether the second operand is a plain number that says how many or which, and no value.
constexpr bool is_numbered(operation op) {
  return op == operation::factorization || op == operation::component;
}

constexpr bool is_commutative(operation op) { return op == operation::add || op == operation::multiply; }

/// The word by which people know the function; empty for arithmetic.
constexpr const char* function_name(operation op) {
  switch (op) {
  case operation::sqrt: return "sqrt";
  case operation::sin: return "sin";
  case operation::cos: return "cos";
  case operation::tan: return "tan";
  case operation::asin: return "asin";
  case operation::acos: return "acos";
  case operation::atan: return "atan";
  case operation::atan2: return "atan2";
  case operation::exp: return "exp";
  case operation::log: return "log";
  case operation::abs: return "abs";
  case operation::sign: return "sign";
  case operation::component: return "solve";
  case operation::regularity: return "regularity";
  default: return "";
  }
}

} // namespace kanexpr::symbolic
