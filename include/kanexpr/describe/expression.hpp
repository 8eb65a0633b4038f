#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/diagnostics/misuse.hpp>
#include <kanexpr/describe/token.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kanexpr {

namespace describe {

/// Returns the operands, followed by a token that represents the mistake.
template <shape kind, class... Operands>
constexpr auto misused(misuse what, const Operands&... x);

} // namespace describe

/// @internal An expression of a model as tokens in postfix order. It is declared in the namespace `kanexpr`
/// itself, so that its operators and functions are found from every namespace.
template <describe::shape is, int size>
struct postfix_expression {
  static constexpr describe::shape kind = is;
  describe::token tokens[static_cast<std::size_t>(size)];

  // The use of these operators is a mistake, but C++ requires them to be members.
  template <class Right>
  constexpr auto operator=(const Right& other) const {
    return describe::misused<describe::shape::equation>(describe::misuse::assignment, *this, other);
  }
  template <class Index>
  constexpr auto operator[](const Index&) const {
    return describe::misused<describe::shape::scalar>(describe::misuse::index, *this);
  }
  template <class... Arguments>
  constexpr auto operator()(const Arguments&...) const {
    return describe::misused<describe::shape::scalar>(describe::misuse::arguments, *this);
  }
};

namespace describe {

using kanexpr::postfix_expression;

} // namespace describe

/// A scalar of a model, written with ordinary operators: `m*r*r/4`, `u3/cos(q2)`.
template <int size>
using scalar = describe::postfix_expression<describe::shape::scalar, size>;

/// A vector of a model: a combination of basis vectors of any frames, as in `u1*L::x + u2*N::y`.
template <int size>
using vector = describe::postfix_expression<describe::shape::vector, size>;

/// A dyadic, a sum of products of vectors, as in `Ixx*outer(L::x, L::x)`.
template <int size>
using dyadic = describe::postfix_expression<describe::shape::dyadic, size>;

/// `left == right`, stored as left − right.
template <int size>
using equation = describe::postfix_expression<describe::shape::equation, size>;

namespace describe {

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

/// Whether a value is the integer 0, such as 1/2 in C++, which is rarely intended in a model.
template <class Written>
constexpr bool is_whole_zero(const Written& value) {
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

} // namespace describe

/// An exact fraction; a plain number would be rounded to double: `rational<1, 3>*m`.
template <std::int64_t numerator, std::int64_t denominator>
inline constexpr scalar<1> rational = [] {
  describe::token t{};
  t.number = denominator == 0 ? symbolic::no_number() : symbolic::exactly(numerator, denominator);
  return scalar<1>{{t}};
}();

} // namespace kanexpr
