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
};

constexpr bool is_leaf(operation op) { return op == operation::constant || op == operation::symbol; }

constexpr bool is_binary(operation op) {
  return op == operation::add || op == operation::subtract || op == operation::multiply ||
         op == operation::divide || op == operation::power || op == operation::atan2;
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
  default: return "";
  }
}

} // namespace kanexpr::symbolic
