#pragma once

#include <kanexpr/describe/misuse.hpp>
#include <kanexpr/describe/token.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kanexpr {

namespace describe {

/// What `dot(q) = u` stands for, a mistake.
template <class X, class Y>
constexpr auto assigned(const X& x, const Y& y);
/// And `q[0]`, and `q(t)`.
template <class X>
constexpr auto with_index(const X& x);
template <class X>
constexpr auto with_arguments(const X& x);

} // namespace describe

/// A scalar of a model, written with ordinary operators: `m*r*r/4`, `u3/cos(q2)`.
template <int size>
struct scalar {
  describe::token tokens[static_cast<std::size_t>(size)];

  template <class T>
  constexpr auto operator=(const T& other) const {
    return describe::assigned(*this, other);
  }
  template <class T>
  constexpr auto operator[](const T&) const {
    return describe::with_index(*this);
  }
  template <class... T>
  constexpr auto operator()(const T&...) const {
    return describe::with_arguments(*this);
  }
};

/// `left == right`, kept as left − right.
template <int size>
struct equation {
  describe::token tokens[static_cast<std::size_t>(size)];
};

namespace describe {

template <class Result, std::size_t a, std::size_t b>
constexpr Result join(const token (&left)[a], const token (&right)[b], const token& last) {
  Result all{};
  for (std::size_t i = 0; i < a; ++i) all.tokens[i] = left[i];
  for (std::size_t i = 0; i < b; ++i) all.tokens[a + i] = right[i];
  all.tokens[a + b] = last;
  return all;
}

template <class Result, std::size_t a>
constexpr Result join(const token (&left)[a], const token& last) {
  Result all{};
  for (std::size_t i = 0; i < a; ++i) all.tokens[i] = left[i];
  all.tokens[a] = last;
  return all;
}

template <class T>
concept plain_number = std::is_arithmetic_v<T> && !std::same_as<T, bool>;

template <plain_number T>
constexpr scalar<1> constant(T value) {
  token t{};
  if constexpr (std::integral<T>) {
    const auto whole = static_cast<std::int64_t>(value);
    if (std::unsigned_integral<T> && whole < 0) // there is no such whole number with a sign
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

/// What is done with a number. To C++ 1/2 is the whole number 0, which nobody writes here on purpose.
template <plain_number T, class Step>
constexpr token done_with(T value, Step what, misuse of_nothing) {
  if constexpr (std::integral<T>)
    if (value == T{}) return misused(of_nothing);
  return with(what);
}

} // namespace describe

template <int a>
constexpr scalar<a + 1> operator-(const scalar<a>& x) {
  return describe::join<scalar<a + 1>>(x.tokens, describe::with(describe::token_kind::negate));
}
template <int a>
constexpr const scalar<a>& operator+(const scalar<a>& x) {
  return x;
}

template <int a, int b>
constexpr scalar<a + b + 1> operator+(const scalar<a>& x, const scalar<b>& y) {
  return describe::join<scalar<a + b + 1>>(x.tokens, y.tokens, describe::with(describe::token_kind::add));
}
template <int a, int b>
constexpr scalar<a + b + 1> operator-(const scalar<a>& x, const scalar<b>& y) {
  return describe::join<scalar<a + b + 1>>(x.tokens, y.tokens,
                                           describe::with(describe::token_kind::subtract));
}
template <int a, int b>
constexpr scalar<a + b + 1> operator*(const scalar<a>& x, const scalar<b>& y) {
  return describe::join<scalar<a + b + 1>>(x.tokens, y.tokens,
                                           describe::with(describe::token_kind::multiply));
}
template <int a, int b>
constexpr scalar<a + b + 1> operator/(const scalar<a>& x, const scalar<b>& y) {
  return describe::join<scalar<a + b + 1>>(x.tokens, y.tokens, describe::with(describe::token_kind::divide));
}
template <int a, int b>
constexpr equation<a + b + 1> operator==(const scalar<a>& x, const scalar<b>& y) {
  return describe::join<equation<a + b + 1>>(x.tokens, y.tokens,
                                             describe::with(describe::token_kind::subtract));
}

template <int a, describe::plain_number T>
constexpr auto operator+(const scalar<a>& x, T y) {
  return x + describe::constant(y);
}
template <int a, describe::plain_number T>
constexpr auto operator+(T x, const scalar<a>& y) {
  return describe::constant(x) + y;
}
template <int a, describe::plain_number T>
constexpr auto operator-(const scalar<a>& x, T y) {
  return x - describe::constant(y);
}
template <int a, describe::plain_number T>
constexpr auto operator-(T x, const scalar<a>& y) {
  return describe::constant(x) - y;
}
template <int a, describe::plain_number T>
constexpr scalar<a + 2> operator*(const scalar<a>& x, T y) {
  return describe::join<scalar<a + 2>>(
      x.tokens, describe::constant(y).tokens,
      describe::done_with(y, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int a, describe::plain_number T>
constexpr scalar<a + 2> operator*(T x, const scalar<a>& y) {
  return describe::join<scalar<a + 2>>(
      describe::constant(x).tokens, y.tokens,
      describe::done_with(x, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int a, describe::plain_number T>
constexpr auto operator/(const scalar<a>& x, T y) {
  return x / describe::constant(y);
}
template <int a, describe::plain_number T>
constexpr scalar<a + 2> operator/(T x, const scalar<a>& y) {
  return describe::join<scalar<a + 2>>(
      describe::constant(x).tokens, y.tokens,
      describe::done_with(x, describe::token_kind::divide, describe::misuse::zero_factor));
}
template <int a, describe::plain_number T>
constexpr auto operator==(const scalar<a>& x, T y) {
  return x == describe::constant(y);
}
template <int a, describe::plain_number T>
constexpr auto operator==(T x, const scalar<a>& y) {
  return describe::constant(x) == y;
}

/// An exact fraction, where a plain number would be a double: `rational<1, 3>*m`.
template <std::int64_t numerator, std::int64_t denominator>
inline constexpr scalar<1> rational = [] {
  describe::token t{};
  t.number = denominator == 0 ? symbolic::no_number() : symbolic::exactly(numerator, denominator);
  return scalar<1>{{t}};
}();

} // namespace kanexpr
