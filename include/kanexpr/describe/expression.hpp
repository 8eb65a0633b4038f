#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/diagnostics/misuse.hpp>
#include <kanexpr/describe/token.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kanexpr {

namespace describe {

/// Returns the result of `dot(q) = u`, which is a mistake.
template <class Left, class Right>
constexpr auto assigned(const Left& x, const Right& y);
/// Returns the result of `q[0]` or `q(t)`, which are mistakes, too.
template <class Operand>
constexpr auto with_index(const Operand& x);
template <class Operand>
constexpr auto with_arguments(const Operand& x);

} // namespace describe

/// A scalar of a model, written with ordinary operators: `m*r*r/4`, `u3/cos(q2)`.
template <int size>
struct scalar {
  describe::token tokens[static_cast<std::size_t>(size)];

  template <class Right>
  constexpr auto operator=(const Right& other) const {
    return describe::assigned(*this, other);
  }
  template <class Index>
  constexpr auto operator[](const Index&) const {
    return describe::with_index(*this);
  }
  template <class... Arguments>
  constexpr auto operator()(const Arguments&...) const {
    return describe::with_arguments(*this);
  }
};

/// `left == right`, stored as left − right.
template <int size>
struct equation {
  describe::token tokens[static_cast<std::size_t>(size)];
};

namespace describe {

template <class Result, std::size_t left_size, std::size_t right_size>
constexpr Result join(const token (&left)[left_size], const token (&right)[right_size], const token& last) {
  Result all{};
  for (std::size_t i = 0; i < left_size; ++i) all.tokens[i] = left[i];
  for (std::size_t i = 0; i < right_size; ++i) all.tokens[left_size + i] = right[i];
  all.tokens[left_size + right_size] = last;
  return all;
}

template <class Result, std::size_t size>
constexpr Result join(const token (&left)[size], const token& last) {
  Result all{};
  for (std::size_t i = 0; i < size; ++i) all.tokens[i] = left[i];
  all.tokens[size] = last;
  return all;
}

template <class Number>
concept plain_number = std::is_arithmetic_v<Number> && !std::same_as<Number, bool> && !base::letter<Number>;

template <plain_number Number>
constexpr scalar<1> constant(Number value) {
  token t{};
  if constexpr (std::integral<Number>) {
    const auto whole = static_cast<std::int64_t>(value);
    if (std::unsigned_integral<Number> && whole < 0) // not representable as a signed integer
      t.number = symbolic::real(static_cast<double>(value));
    else
      t.number = symbolic::exactly(whole);
  } else
    t.number = symbolic::real(static_cast<double>(value));
  return {{t}};
}

constexpr token with(token_kind what) {
  token t{};
  t.what = what;
  return t;
}

constexpr token with(symbolic::operation function) {
  token t{};
  t.what = token_kind::scalar_function;
  t.operation = function;
  return t;
}

constexpr token misused(misuse what) {
  token t = with(token_kind::misused);
  t.index = static_cast<int>(what);
  return t;
}

/// Whether a value is the integer 0, such as 1/2 in C++; it is hardly ever written on purpose in a model.
template <class Written>
constexpr bool is_whole_zero(Written value) {
  if constexpr (plain_number<Written> && std::integral<Written>)
    return value == Written{};
  else
    return false;
}

/// Converts a number to an expression.
template <plain_number Number>
constexpr scalar<1> number(Number value) {
  if (is_whole_zero(value)) return {{misused(misuse::zero)}};
  return constant(value);
}

/// Converts a number to a side of an equation, where 0 is allowed; the value reader rejects a parameter bound
/// to 0.
template <plain_number Number>
constexpr scalar<1> side(Number value) {
  scalar<1> x = constant(value);
  x.tokens[0].index = is_whole_zero(value) ? whole_zero : 0;
  return x;
}

/// Returns the operation applied to a number, or a mistake if the number is the integer 0.
template <plain_number Number, class Step>
constexpr token done_with(Number value, Step what, misuse of_nothing) {
  return is_whole_zero(value) ? misused(of_nothing) : with(what);
}

} // namespace describe

template <int size>
constexpr scalar<size + 1> operator-(const scalar<size>& x) {
  return describe::join<scalar<size + 1>>(x.tokens, describe::with(describe::token_kind::negate));
}
template <int size>
constexpr const scalar<size>& operator+(const scalar<size>& x) {
  return x;
}

template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> operator+(const scalar<left_size>& x,
                                                       const scalar<right_size>& y) {
  return describe::join<scalar<left_size + right_size + 1>>(x.tokens, y.tokens,
                                                            describe::with(describe::token_kind::add));
}
template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> operator-(const scalar<left_size>& x,
                                                       const scalar<right_size>& y) {
  return describe::join<scalar<left_size + right_size + 1>>(x.tokens, y.tokens,
                                                            describe::with(describe::token_kind::subtract));
}
template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> operator*(const scalar<left_size>& x,
                                                       const scalar<right_size>& y) {
  return describe::join<scalar<left_size + right_size + 1>>(x.tokens, y.tokens,
                                                            describe::with(describe::token_kind::multiply));
}
template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> operator/(const scalar<left_size>& x,
                                                       const scalar<right_size>& y) {
  return describe::join<scalar<left_size + right_size + 1>>(x.tokens, y.tokens,
                                                            describe::with(describe::token_kind::divide));
}
template <int left_size, int right_size>
constexpr equation<left_size + right_size + 1> operator==(const scalar<left_size>& x,
                                                          const scalar<right_size>& y) {
  return describe::join<equation<left_size + right_size + 1>>(x.tokens, y.tokens,
                                                              describe::with(describe::token_kind::subtract));
}

template <int size, describe::plain_number Number>
constexpr auto operator+(const scalar<size>& x, Number y) {
  return x + describe::number(y);
}
template <int size, describe::plain_number Number>
constexpr auto operator+(Number x, const scalar<size>& y) {
  return describe::number(x) + y;
}
template <int size, describe::plain_number Number>
constexpr auto operator-(const scalar<size>& x, Number y) {
  return x - describe::number(y);
}
template <int size, describe::plain_number Number>
constexpr auto operator-(Number x, const scalar<size>& y) {
  return describe::number(x) - y;
}
template <int size, describe::plain_number Number>
constexpr scalar<size + 2> operator*(const scalar<size>& x, Number y) {
  return describe::join<scalar<size + 2>>(
      x.tokens, describe::constant(y).tokens,
      describe::done_with(y, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int size, describe::plain_number Number>
constexpr scalar<size + 2> operator*(Number x, const scalar<size>& y) {
  return describe::join<scalar<size + 2>>(
      describe::constant(x).tokens, y.tokens,
      describe::done_with(x, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int size, describe::plain_number Number>
constexpr auto operator/(const scalar<size>& x, Number y) {
  return x / describe::constant(y);
}
template <int size, describe::plain_number Number>
constexpr scalar<size + 2> operator/(Number x, const scalar<size>& y) {
  return describe::join<scalar<size + 2>>(
      describe::constant(x).tokens, y.tokens,
      describe::done_with(x, describe::token_kind::divide, describe::misuse::zero_factor));
}
template <int size, describe::plain_number Number>
constexpr auto operator==(const scalar<size>& x, Number y) {
  return x == describe::side(y);
}
template <int size, describe::plain_number Number>
constexpr auto operator==(Number x, const scalar<size>& y) {
  return describe::side(x) == y;
}

/// An exact fraction, where a plain number would be rounded to double: `rational<1, 3>*m`.
template <std::int64_t numerator, std::int64_t denominator>
inline constexpr scalar<1> rational = [] {
  describe::token t{};
  t.number = denominator == 0 ? symbolic::no_number() : symbolic::exactly(numerator, denominator);
  return scalar<1>{{t}};
}();

} // namespace kanexpr
