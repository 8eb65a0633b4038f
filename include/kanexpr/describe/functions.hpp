#pragma once

#include <kanexpr/describe/composed.hpp>
#include <kanexpr/describe/external.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Functions of expressions. The model reader rejects arguments that are not scalars.
namespace kanexpr {

namespace describe {

template <class Left, class Right>
constexpr auto function_of(symbolic::operation f, const Left& x, const Right& y) {
  if constexpr (are_quantities<Left, Right> && are_scalars<Left, Right>)
    return joined<shape::scalar>(with(f), operand(x), operand(y));
  else
    return as_written<shape::scalar>(with(f), x, y);
}

} // namespace describe

#define KANEXPR_FUNCTION(name)                                                                               \
  template <describe::expression_of_a_model Operand>                                                         \
  constexpr auto(name)(const Operand& x) {                                                                   \
    return describe::as_written<describe::shape::scalar>(describe::with(symbolic::operation::name), x);      \
  }

/// √x. Its derivative is infinite at 0; it is NaN for negative x.
KANEXPR_FUNCTION(sqrt)
/// The sine of an angle in rad.
KANEXPR_FUNCTION(sin)
/// The cosine of an angle in rad.
KANEXPR_FUNCTION(cos)
/// The tangent of an angle in rad.
KANEXPR_FUNCTION(tan)
/// The angle in [−π/2, π/2] whose sine is x, in rad; NaN if |x| > 1.
KANEXPR_FUNCTION(asin)
/// The angle in [0, π] whose cosine is x, in rad; NaN if |x| > 1.
KANEXPR_FUNCTION(acos)
/// The angle in (−π/2, π/2) whose tangent is x, in rad.
KANEXPR_FUNCTION(atan)
/// The exponential function eˣ.
KANEXPR_FUNCTION(exp)
/// The natural logarithm; NaN for negative x.
KANEXPR_FUNCTION(log)
/// The hyperbolic sine.
KANEXPR_FUNCTION(sinh)
/// The hyperbolic cosine.
KANEXPR_FUNCTION(cosh)
/// The hyperbolic tangent.
KANEXPR_FUNCTION(tanh)
/// The magnitude |x|, with a corner at 0. Its derivative is `sign(x)`.
KANEXPR_FUNCTION(abs)
/// −1, 0 or 1, with a step at 0. Its derivative is 0.
KANEXPR_FUNCTION(sign)
/// The real cube root, also of negative numbers. Its derivative is infinite at 0.
KANEXPR_FUNCTION(cbrt)
/// The error function, 2/√π times the integral of exp(−s²) from 0 to x.
KANEXPR_FUNCTION(erf)
/// The angle x in rad minus the multiple of 2π that leaves a value in [−π, π). Its derivative is 1, also
/// at the jumps.
KANEXPR_FUNCTION(wrap_to_pi)
#undef KANEXPR_FUNCTION

/// The angle in (−π, π] of the point (x, y) from the x axis, in rad; undefined at the origin.
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto atan2(const Left& y, const Right& x) {
  return describe::function_of(symbolic::operation::atan2, y, x);
}

/// x to the power of y; a constant exponent may be any number except the integer 0.
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto pow(const Left& x, const Right& y) {
  if constexpr (describe::are_scalars<Left> && describe::plain_number<Right>)
    return describe::as_written<describe::shape::scalar>(describe::is_whole_zero(y)
                                                             ? describe::misused(describe::misuse::zero_power)
                                                             : describe::with(symbolic::operation::power),
                                                         x, y);
  else
    return describe::function_of(symbolic::operation::power, x, y);
}

// Functions that C++ provides but models do not support; they are declared so that an error message can
// report their use.

#define KANEXPR_UNSUPPORTED_FUNCTION(name)                                                                   \
  template <describe::expression_of_a_model Operand>                                                         \
  constexpr auto(name)(const Operand& x) {                                                                   \
    return describe::misused<describe::shape::scalar>(describe::misuse::function, x);                        \
  }

KANEXPR_UNSUPPORTED_FUNCTION(asinh)
KANEXPR_UNSUPPORTED_FUNCTION(acosh)
KANEXPR_UNSUPPORTED_FUNCTION(atanh)
KANEXPR_UNSUPPORTED_FUNCTION(exp2)
KANEXPR_UNSUPPORTED_FUNCTION(log2)
KANEXPR_UNSUPPORTED_FUNCTION(log10)
KANEXPR_UNSUPPORTED_FUNCTION(floor)
KANEXPR_UNSUPPORTED_FUNCTION(ceil)
KANEXPR_UNSUPPORTED_FUNCTION(round)
KANEXPR_UNSUPPORTED_FUNCTION(fabs)
#undef KANEXPR_UNSUPPORTED_FUNCTION

/// @internal Not available in models; declared so that an error sentence can report its use.
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto fmod(const Left& x, const Right& y) {
  return describe::misused<describe::shape::scalar>(describe::misuse::function, x, y);
}

} // namespace kanexpr
