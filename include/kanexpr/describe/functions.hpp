#pragma once

#include <kanexpr/describe/composed.hpp>
#include <kanexpr/describe/external.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Functions of expressions. The reader of the model rejects arguments that are not scalars.
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

KANEXPR_FUNCTION(sqrt)
KANEXPR_FUNCTION(sin)
KANEXPR_FUNCTION(cos)
KANEXPR_FUNCTION(tan)
KANEXPR_FUNCTION(asin)
KANEXPR_FUNCTION(acos)
KANEXPR_FUNCTION(atan)
KANEXPR_FUNCTION(exp)
KANEXPR_FUNCTION(log)
KANEXPR_FUNCTION(sinh)
KANEXPR_FUNCTION(cosh)
KANEXPR_FUNCTION(tanh)
KANEXPR_FUNCTION(abs)
KANEXPR_FUNCTION(sign)
KANEXPR_FUNCTION(cbrt)
KANEXPR_FUNCTION(erf)
KANEXPR_FUNCTION(wrap_to_pi)
#undef KANEXPR_FUNCTION

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

// Functions that C++ provides but models do not support; they are declared so that an error sentence can
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
