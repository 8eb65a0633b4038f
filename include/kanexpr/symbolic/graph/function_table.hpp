#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <iterator>
#include <limits>

/// The functions of one and of two arguments, one row each.
namespace kanexpr::symbolic {

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

/// Whether the argument or the value of a function is an angle; angles are dimensionless.
enum class angle_rule { none, argument, value, both };

/// How C calls a function: by a name in <math.h>, or as a function that the exporter writes along with the
/// code. In its body, `x` and `y` are the arguments, and the exporter replaces `@number@` (the type), `@f@`
/// (the suffix of math.h functions), `@zero@`, `@one@`, `@pi@`, `@turn@` and `@name@` (the prefix of
/// `_choose`).
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
  double steep_at = everywhere; ///< where it is continuous with an infinite slope; must be increasing there
  int exact_at = nowhere;       ///< the integer at which its value is an integer
  unit_rule unit = unit_rule::numbers;
  angle_rule angle = angle_rule::none;
  bool is_trigonometric = false; ///< counted as trigonometric, otherwise as `other`
  bool never_negative = false;
  bool stays_finite = false;    ///< finite if its argument is finite
  bool passes_infinity = false; ///< not finite if its argument is not
  bool has_complex = true;      ///< defined in <complex>; otherwise complex steps use its derivative

  constexpr bool is_smooth_at(double x) const {
    return x > smooth_from && x < smooth_to && (x < steep_at || x > steep_at);
  }
  /// Whether the value and the slope are finite wherever the argument is.
  constexpr bool has_finite_slopes() const {
    return stays_finite && smooth_from <= -everywhere && smooth_to >= everywhere && steep_at >= everywhere;
  }
};

/// Listed in the order of the operations.
inline constexpr function_properties functions[] = {
    {.op = operation::sqrt,
     .name = "sqrt",
     .value = numeric::elementary::sqrt,
     .latex = "\\sqrt",
     .smooth_from = 0,
     .unit = unit_rule::root,
     .never_negative = true,
     .passes_infinity = true},
    {.op = operation::sin,
     .name = "sin",
     .value = numeric::elementary::sin,
     .latex = "\\sin",
     .symmetry = parity::odd,
     .exact_at = 0,
     .angle = angle_rule::argument,
     .is_trigonometric = true,
     .stays_finite = true,
     .passes_infinity = true},
    {.op = operation::cos,
     .name = "cos",
     .value = numeric::elementary::cos,
     .latex = "\\cos",
     .symmetry = parity::even,
     .exact_at = 0,
     .angle = angle_rule::argument,
     .is_trigonometric = true,
     .stays_finite = true,
     .passes_infinity = true},
    {.op = operation::tan,
     .name = "tan",
     .value = numeric::elementary::tan,
     .latex = "\\tan",
     .symmetry = parity::odd,
     .exact_at = 0,
     .angle = angle_rule::argument,
     .is_trigonometric = true,
     .stays_finite = true, // rounding keeps it finite
     .passes_infinity = true},
    {.op = operation::asin,
     .name = "asin",
     .value = numeric::elementary::asin,
     .latex = "\\arcsin",
     .symmetry = parity::odd,
     .smooth_from = -1,
     .smooth_to = 1,
     .exact_at = 0,
     .angle = angle_rule::value,
     .is_trigonometric = true},
    {.op = operation::acos,
     .name = "acos",
     .value = numeric::elementary::acos,
     .latex = "\\arccos",
     .smooth_from = -1,
     .smooth_to = 1,
     .exact_at = 1,
     .angle = angle_rule::value,
     .is_trigonometric = true},
    {.op = operation::atan,
     .name = "atan",
     .value = numeric::elementary::atan,
     .latex = "\\arctan",
     .symmetry = parity::odd,
     .exact_at = 0,
     .angle = angle_rule::value,
     .is_trigonometric = true,
     .stays_finite = true},
    {.op = operation::exp,
     .name = "exp",
     .value = numeric::elementary::exp,
     .latex = "\\exp",
     .exact_at = 0,
     .never_negative = true},
    {.op = operation::log,
     .name = "log",
     .value = numeric::elementary::log,
     .latex = "\\ln",
     .smooth_from = 0,
     .exact_at = 1},
    {.op = operation::sinh,
     .name = "sinh",
     .value = numeric::elementary::sinh,
     .latex = "\\sinh",
     .symmetry = parity::odd,
     .exact_at = 0,
     .passes_infinity = true},
    {.op = operation::cosh,
     .name = "cosh",
     .value = numeric::elementary::cosh,
     .latex = "\\cosh",
     .symmetry = parity::even,
     .exact_at = 0,
     .never_negative = true,
     .passes_infinity = true},
    {.op = operation::tanh,
     .name = "tanh",
     .value = numeric::elementary::tanh,
     .latex = "\\tanh",
     .symmetry = parity::odd,
     .exact_at = 0,
     .stays_finite = true},
    {.op = operation::abs,
     .name = "abs",
     .value = numeric::elementary::abs,
     .in_c = {.name = "fabs"},
     .symmetry = parity::even,
     .unit = unit_rule::kept,
     .never_negative = true,
     .stays_finite = true,
     .passes_infinity = true,
     .has_complex = false},
    {.op = operation::sign,
     .name = "sign",
     .value = numeric::elementary::sign,
     .in_c = {.body = "  return @name@_choose(x, @one@, @name@_choose(-x, -@one@, x + @zero@));\n"},
     .symmetry = parity::odd,
     .unit = unit_rule::dropped,
     .stays_finite = true,
     .has_complex = false},
    {.op = operation::cbrt,
     .name = "cbrt",
     .value = numeric::elementary::cbrt,
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
     .value = numeric::elementary::erf,
     .symmetry = parity::odd,
     .exact_at = 0,
     .stays_finite = true,
     .has_complex = false},
    {.op = operation::wrap_to_pi, // not odd: both ends of the interval are wrapped to -π
     .name = "wrap_to_pi",
     .value = numeric::elementary::wrap_to_pi,
     .latex = "\\operatorname{wrap}_{\\pi}",
     .in_c = {.body = "  const @number@ r = remainder@f@(x, @turn@);\n"
                      "  return r - (@number@)(r >= @pi@) * @turn@;\n"},
     .exact_at = 0,
     .angle = angle_rule::both,
     .stays_finite = true,
     .passes_infinity = true,
     .has_complex = false},
};

/// The unit of the value of a function of two arguments.
enum class binary_unit_rule {
  numbers, ///< dimensionless, for dimensionless arguments
  ratio,   ///< an angle, which is dimensionless, for arguments of the same unit
  kept,    ///< the unit of both arguments
};

/// The properties of a function of two arguments except its derivatives (functions.hpp). The defaults
/// are safe for every function.
struct binary_function_properties {
  operation op;
  const char* name;                ///< its name in C++
  double (*value)(double, double); ///< evaluates the function in constant expressions
  spelling_in_c in_c = {};
  bool (*is_smooth_at)(double, double) = [](double, double) { return true; };
  bool (*is_exact_at)(double, double) = [](double, double) { return false; }; ///< for exact arguments
  binary_unit_rule unit = binary_unit_rule::numbers;
  bool is_trigonometric = false; ///< an angle, whose error is that of its first argument
  bool stays_finite = false;     ///< finite wherever its arguments are finite
};

/// Listed in the order of the operations.
inline constexpr binary_function_properties binary_functions[] = {
    {.op = operation::atan2,
     .name = "atan2",
     .value = numeric::elementary::atan2,
     .is_smooth_at = [](double y, double x) { return !base::equal(y, 0.0) || !base::equal(x, 0.0); },
     .is_exact_at = [](double y, double x) { return base::equal(y, 0.0) && x >= 0; },
     .unit = binary_unit_rule::ratio,
     .is_trigonometric = true,
     .stays_finite = true},
};

namespace detail {

constexpr int place_of_function(operation op) {
  return static_cast<int>(op) - static_cast<int>(operation::sqrt) - (op > operation::atan2 ? 1 : 0);
}

constexpr int place_of_binary_function(operation op) {
  return op == operation::atan2 ? 0 : static_cast<int>(op) - static_cast<int>(last_function);
}

/// Whether each row is at the index of its operation.
template <class Rows>
constexpr bool are_in_order(const Rows& rows, bool (*belongs)(operation), int (*place_of)(operation)) {
  int place = 0;
  for (const auto& row : rows)
    if (!belongs(row.op) || place_of(row.op) != place++) return false;
  return true;
}
static_assert(are_in_order(functions, is_function, place_of_function));
static_assert(std::size(functions) == place_of_function(last_function) + 1);
static_assert(are_in_order(binary_functions, is_binary_function, place_of_binary_function));
static_assert(std::size(binary_functions) == place_of_binary_function(operation::if_positive));

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

/// The C++ name of the function; empty for arithmetic, lists and calls, whose names are stored in the graph.
constexpr const char* function_name(operation op) {
  if (is_function(op)) return properties_of(op).name;
  if (is_binary_function(op)) return binary_properties_of(op).name;
  if (is_selection(op)) return "if_positive";
  if (op == operation::component) return "solve";
  return op == operation::singularity_measure ? "singularity_measure" : "";
}

} // namespace kanexpr::symbolic
