#pragma once

#include <kanexpr/describe/composed.hpp>
#include <kanexpr/describe/external.hpp>
#include <kanexpr/describe/mistaken.hpp>
#include <kanexpr/describe/mixed.hpp>

/// Functions of expressions. Of what is no scalar they mean nothing, which the reader of the model says.
namespace kanexpr {

namespace describe {

template <int a>
constexpr scalar<a + 1> function_of(symbolic::operation f, const scalar<a>& x) {
  return join<scalar<a + 1>>(x.tokens, with(f));
}
template <int a, int b>
constexpr scalar<a + b + 1> function_of(symbolic::operation f, const scalar<a>& x, const scalar<b>& y) {
  return join<scalar<a + b + 1>>(x.tokens, y.tokens, with(f));
}

} // namespace describe

template <int a>
constexpr auto sqrt(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::sqrt, x);
}
template <describe::no_scalar X>
constexpr auto sqrt(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::sqrt));
}

template <int a>
constexpr auto sin(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::sin, x);
}
template <describe::no_scalar X>
constexpr auto sin(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::sin));
}

template <int a>
constexpr auto cos(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::cos, x);
}
template <describe::no_scalar X>
constexpr auto cos(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::cos));
}

template <int a>
constexpr auto tan(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::tan, x);
}
template <describe::no_scalar X>
constexpr auto tan(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::tan));
}

template <int a>
constexpr auto asin(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::asin, x);
}
template <describe::no_scalar X>
constexpr auto asin(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::asin));
}

template <int a>
constexpr auto acos(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::acos, x);
}
template <describe::no_scalar X>
constexpr auto acos(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::acos));
}

template <int a>
constexpr auto atan(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::atan, x);
}
template <describe::no_scalar X>
constexpr auto atan(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::atan));
}

template <int a>
constexpr auto exp(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::exp, x);
}
template <describe::no_scalar X>
constexpr auto exp(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::exp));
}

template <int a>
constexpr auto log(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::log, x);
}
template <describe::no_scalar X>
constexpr auto log(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::log));
}

template <int a>
constexpr auto sinh(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::sinh, x);
}
template <describe::no_scalar X>
constexpr auto sinh(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::sinh));
}

template <int a>
constexpr auto cosh(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::cosh, x);
}
template <describe::no_scalar X>
constexpr auto cosh(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::cosh));
}

template <int a>
constexpr auto tanh(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::tanh, x);
}
template <describe::no_scalar X>
constexpr auto tanh(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::tanh));
}

template <int a>
constexpr auto abs(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::abs, x);
}
template <describe::no_scalar X>
constexpr auto abs(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::abs));
}

template <int a>
constexpr auto sign(const scalar<a>& x) {
  return describe::function_of(symbolic::operation::sign, x);
}
template <describe::no_scalar X>
constexpr auto sign(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(symbolic::operation::sign));
}

template <int a, int b>
constexpr auto atan2(const scalar<a>& y, const scalar<b>& x) {
  return describe::function_of(symbolic::operation::atan2, y, x);
}
template <int a, describe::plain_number T>
constexpr auto atan2(const scalar<a>& y, T x) {
  return atan2(y, describe::constant(x));
}
template <int a, describe::plain_number T>
constexpr auto atan2(T y, const scalar<a>& x) {
  return atan2(describe::constant(y), x);
}
template <class X, class Y>
  requires describe::no_function<X, Y>
constexpr auto atan2(const X& x, const Y& y) {
  return describe::meaningless<scalar>(x, y, describe::with(symbolic::operation::atan2));
}

template <int a, int b>
constexpr auto pow(const scalar<a>& x, const scalar<b>& exponent) {
  return describe::function_of(symbolic::operation::power, x, exponent);
}
template <int a, describe::plain_number T>
constexpr scalar<a + 2> pow(const scalar<a>& x, T exponent) {
  return describe::join<scalar<a + 2>>(
      x.tokens, describe::constant(exponent).tokens,
      describe::done_with(exponent, symbolic::operation::power, describe::misuse::zero_power));
}
template <int a, describe::plain_number T>
constexpr auto pow(T x, const scalar<a>& exponent) {
  return pow(describe::constant(x), exponent);
}
template <class X, class Y>
  requires describe::no_function<X, Y>
constexpr auto pow(const X& x, const Y& y) {
  return describe::meaningless<scalar>(x, y, describe::with(symbolic::operation::power));
}

// Those that C++ has and models do not, to say so.

template <describe::expression_of_a_model X>
constexpr auto asinh(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto acosh(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto atanh(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto cbrt(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto exp2(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto log2(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto log10(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto floor(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto ceil(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto(round)(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <describe::expression_of_a_model X>
constexpr auto fabs(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::function);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto fmod(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::function);
}

} // namespace kanexpr
