#pragma once

#include <kanexpr/describe/composed.hpp>
#include <kanexpr/describe/diagnostics/mismatched_operands.hpp>
#include <kanexpr/describe/diagnostics/unsupported_operators.hpp>
#include <kanexpr/describe/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Functions of expressions. The reader of the model rejects arguments that are not scalars.
namespace kanexpr {

namespace describe {

template <int size>
constexpr scalar<size + 1> function_of(symbolic::operation f, const scalar<size>& x) {
  return join<scalar<size + 1>>(x.tokens, with(f));
}
template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> function_of(symbolic::operation f, const scalar<left_size>& x,
                                                         const scalar<right_size>& y) {
  return join<scalar<left_size + right_size + 1>>(x.tokens, y.tokens, with(f));
}

} // namespace describe

template <int size>
constexpr auto sqrt(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::sqrt, x);
}
template <describe::no_scalar Operand>
constexpr auto sqrt(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::sqrt));
}

template <int size>
constexpr auto sin(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::sin, x);
}
template <describe::no_scalar Operand>
constexpr auto sin(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::sin));
}

template <int size>
constexpr auto cos(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::cos, x);
}
template <describe::no_scalar Operand>
constexpr auto cos(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::cos));
}

template <int size>
constexpr auto tan(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::tan, x);
}
template <describe::no_scalar Operand>
constexpr auto tan(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::tan));
}

template <int size>
constexpr auto asin(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::asin, x);
}
template <describe::no_scalar Operand>
constexpr auto asin(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::asin));
}

template <int size>
constexpr auto acos(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::acos, x);
}
template <describe::no_scalar Operand>
constexpr auto acos(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::acos));
}

template <int size>
constexpr auto atan(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::atan, x);
}
template <describe::no_scalar Operand>
constexpr auto atan(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::atan));
}

template <int size>
constexpr auto exp(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::exp, x);
}
template <describe::no_scalar Operand>
constexpr auto exp(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::exp));
}

template <int size>
constexpr auto log(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::log, x);
}
template <describe::no_scalar Operand>
constexpr auto log(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::log));
}

template <int size>
constexpr auto sinh(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::sinh, x);
}
template <describe::no_scalar Operand>
constexpr auto sinh(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::sinh));
}

template <int size>
constexpr auto cosh(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::cosh, x);
}
template <describe::no_scalar Operand>
constexpr auto cosh(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::cosh));
}

template <int size>
constexpr auto tanh(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::tanh, x);
}
template <describe::no_scalar Operand>
constexpr auto tanh(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::tanh));
}

template <int size>
constexpr auto abs(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::abs, x);
}
template <describe::no_scalar Operand>
constexpr auto abs(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::abs));
}

template <int size>
constexpr auto sign(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::sign, x);
}
template <describe::no_scalar Operand>
constexpr auto sign(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::sign));
}

template <int size>
constexpr auto cbrt(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::cbrt, x);
}
template <describe::no_scalar Operand>
constexpr auto cbrt(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::cbrt));
}

template <int size>
constexpr auto erf(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::erf, x);
}
template <describe::no_scalar Operand>
constexpr auto erf(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::erf));
}

template <int size>
constexpr auto wrap_to_pi(const scalar<size>& x) {
  return describe::function_of(symbolic::operation::wrap_to_pi, x);
}
template <describe::no_scalar Operand>
constexpr auto wrap_to_pi(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(symbolic::operation::wrap_to_pi));
}

template <int left_size, int right_size>
constexpr auto atan2(const scalar<left_size>& y, const scalar<right_size>& x) {
  return describe::function_of(symbolic::operation::atan2, y, x);
}
template <int size, describe::plain_number Number>
constexpr auto atan2(const scalar<size>& y, Number x) {
  return atan2(y, describe::number(x));
}
template <int size, describe::plain_number Number>
constexpr auto atan2(Number y, const scalar<size>& x) {
  return atan2(describe::number(y), x);
}
template <class Left, class Right>
  requires describe::no_function<Left, Right>
constexpr auto atan2(const Left& x, const Right& y) {
  return describe::mismatched<scalar>(x, y, describe::with(symbolic::operation::atan2));
}

template <int left_size, int right_size>
constexpr auto pow(const scalar<left_size>& x, const scalar<right_size>& exponent) {
  return describe::function_of(symbolic::operation::power, x, exponent);
}
template <int size, describe::plain_number Number>
constexpr scalar<size + 2> pow(const scalar<size>& x, Number exponent) {
  return describe::join<scalar<size + 2>>(
      x.tokens, describe::constant(exponent).tokens,
      describe::done_with(exponent, symbolic::operation::power, describe::misuse::zero_power));
}
template <int size, describe::plain_number Number>
constexpr auto pow(Number x, const scalar<size>& exponent) {
  return pow(describe::number(x), exponent);
}
template <class Left, class Right>
  requires describe::no_function<Left, Right>
constexpr auto pow(const Left& x, const Right& y) {
  return describe::mismatched<scalar>(x, y, describe::with(symbolic::operation::power));
}

// Functions that C++ has but models do not; they are declared so that an error sentence can report their use.

template <describe::expression_of_a_model Operand>
constexpr auto asinh(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto acosh(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto atanh(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto exp2(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto log2(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto log10(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto floor(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto ceil(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto(round)(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model Operand>
constexpr auto fabs(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto fmod(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::function);
}

} // namespace kanexpr
