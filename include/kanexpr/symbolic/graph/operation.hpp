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
  // functions of one argument, up to `last_function`; `functions` lists their properties
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2, ///< of two arguments
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

inline constexpr operation last_function = operation::wrap_to_pi;

constexpr bool is_binary(operation op) {
  return (op >= operation::add && op <= operation::power) || op == operation::atan2 || op > last_function;
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

/// Whether the operation is a function of one argument.
constexpr bool is_function(operation op) {
  return op >= operation::sqrt && op <= last_function && op != operation::atan2;
}

/// Whether the operation is a function of two arguments; powers and selections are not.
constexpr bool is_binary_function(operation op) {
  return op == operation::atan2 || (op > last_function && op < operation::if_positive);
}

/// The forms of operations; all functions of one argument have the same form, and so do all of two. Code that
/// treats these functions alike switches over forms, so that adding a function does not affect it.
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
  binary_function,
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
  if (op < operation::if_positive) return is_binary_function(op) ? form::binary_function : form::function;
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
  cube_root,
  dropped, ///< dimensionless, for any argument
};

/// How C calls a function: by a name in <math.h>, or as a function that the exporter writes next to the code.
/// In its body, `x` and `y` are the arguments, and the exporter replaces `@number@` (the type), `@f@` (the
/// suffix of functions of math.h), `@zero@`, `@one@`, `@pi@`, `@turn@` and `@name@`, which begins `_choose`.
struct spelling_in_c {
  const char* name = ""; ///< if empty, the name in C++
  const char* body = "";
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
  spelling_in_c in_c = {};
  parity symmetry = parity::none;
  double smooth_from = -everywhere, smooth_to = everywhere; ///< open interval where differentiable
  double steep_at = everywhere; ///< where it is continuous but has an infinite slope; it must increase
  int exact_at = nowhere;       ///< the integer at which its value is an integer
  unit_rule unit = unit_rule::numbers;
  bool is_trigonometric = false; ///< counted as trigonometric, otherwise as `other`
  bool never_negative = false;
  bool stays_finite = false;    ///< finite if its argument is finite
  bool passes_infinity = false; ///< not finite if its argument is not
  bool has_complex = true;      ///< <complex> has it; otherwise complex steps use its derivative

  constexpr bool is_smooth_at(double x) const {
    return x > smooth_from && x < smooth_to && (x < steep_at || x > steep_at);
  }
  /// Whether the value and the slope are finite wherever the argument is.
  constexpr bool has_finite_slopes() const {
    return stays_finite && smooth_from <= -everywhere && smooth_to >= everywhere && steep_at >= everywhere;
  }
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
     .in_c = {.name = "fabs"},
     .symmetry = parity::even,
     .unit = unit_rule::kept,
     .never_negative = true,
     .stays_finite = true,
     .passes_infinity = true,
     .has_complex = false},
    {.op = operation::sign,
     .name = "sign",
     .value = elementary::sign,
     .in_c = {.body = "  return @name@_choose(x, @one@, @name@_choose(-x, -@one@, x + @zero@));\n"},
     .symmetry = parity::odd,
     .unit = unit_rule::dropped,
     .stays_finite = true,
     .has_complex = false},
    {.op = operation::cbrt,
     .name = "cbrt",
     .value = elementary::cbrt,
     .latex = "\\sqrt[3]",
     .symmetry = parity::odd,
     .steep_at = 0,
     .exact_at = 1,
     .unit = unit_rule::cube_root,
     .stays_finite = true,
     .passes_infinity = true,
     .has_complex = false},
    {.op = operation::erf,
     .name = "erf",
     .value = elementary::erf,
     .symmetry = parity::odd,
     .exact_at = 0,
     .stays_finite = true,
     .has_complex = false},
    {.op = operation::wrap_to_pi, // not odd: both ends of the interval are wrapped to -π
     .name = "wrap_to_pi",
     .value = elementary::wrap_to_pi,
     .latex = "\\operatorname{wrap}_{\\pi}",
     .in_c = {.body = "  const @number@ r = remainder@f@(x, @turn@);\n"
                      "  return r - (@number@)(r >= @pi@) * @turn@;\n"},
     .exact_at = 0,
     .stays_finite = true,
     .passes_infinity = true,
     .has_complex = false},
};

/// The unit of the value of a function of two arguments.
enum class binary_unit_rule {
  numbers, ///< dimensionless, for dimensionless arguments
  ratio,   ///< dimensionless, for arguments of one unit
  kept,    ///< the unit of both arguments
};

/// The properties of a function of two arguments besides its derivatives (binary_functions.hpp). The defaults
/// are safe for every function.
struct binary_function_properties {
  operation op;
  const char* name;                ///< its name in C++
  double (*value)(double, double); ///< in constant expressions
  spelling_in_c in_c = {};
  bool (*is_smooth_at)(double, double) = [](double, double) { return true; };
  bool (*is_exact_at)(double, double) = [](double, double) { return false; }; ///< for exact arguments
  binary_unit_rule unit = binary_unit_rule::numbers;
  bool is_trigonometric = false; ///< an angle, whose error is that of its first argument
  bool stays_finite = false;     ///< finite wherever its arguments are finite
};

/// In the order of the operations.
inline constexpr binary_function_properties binary_functions[] = {
    {.op = operation::atan2,
     .name = "atan2",
     .value = elementary::atan2,
     .is_smooth_at = [](double y, double x) { return !numeric::equal(y, 0.0) || !numeric::equal(x, 0.0); },
     .is_exact_at = [](double y, double x) { return numeric::equal(y, 0.0) && x >= 0; },
     .unit = binary_unit_rule::ratio,
     .is_trigonometric = true,
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
  return place == place_of_function(last_function) + 1;
}
static_assert(every_function_has_its_place());

constexpr int place_of_binary_function(operation op) {
  return op == operation::atan2 ? 0 : static_cast<int>(op) - static_cast<int>(last_function);
}

constexpr bool every_binary_function_has_its_place() {
  int place = 0;
  for (const binary_function_properties& f : binary_functions)
    if (!is_binary_function(f.op) || place_of_binary_function(f.op) != place++) return false;
  return place == place_of_binary_function(operation::if_positive);
}
static_assert(every_binary_function_has_its_place());

} // namespace detail

/// The properties of a function of one argument.
constexpr const function_properties& properties_of(operation op) {
  return functions[detail::place_of_function(op)];
}

/// The properties of a function of two arguments.
constexpr const binary_function_properties& binary_properties_of(operation op) {
  return binary_functions[detail::place_of_binary_function(op)];
}

constexpr const spelling_in_c& spelling_of(operation op) {
  return is_binary_function(op) ? binary_properties_of(op).in_c : properties_of(op).in_c;
}

/// The C++ name of the function; empty for arithmetic.
constexpr const char* function_name(operation op) {
  switch (form_of(op)) {
  case form::function: return properties_of(op).name;
  case form::binary_function: return binary_properties_of(op).name;
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
