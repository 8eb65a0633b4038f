#pragma once

#include <kanexpr/describe/operand.hpp>

/// Expressions that mean nothing by the kinds of their operands, such as `u1 + N::x`. They are kept as they
/// stand: who reads the model knows which point or frame they belong to, and says so.
namespace kanexpr {

namespace describe {

template <class X, class Y>
inline constexpr bool equates =
    shape_of_operand<X> == shape::equation || shape_of_operand<Y> == shape::equation;
/// One of them is no quantity at all.
template <class X, class Y>
inline constexpr bool strange = equates<X, Y> || std::same_as<X, bool> || std::same_as<Y, bool>;

template <class X, class Y>
concept no_sum = written<X> && written<Y> && (strange<X, Y> || shape_of_operand<X> != shape_of_operand<Y>);
template <class X, class Y>
concept no_product = written<X> && written<Y> && (strange<X, Y> || (no_scalar<X> && no_scalar<Y>));
template <class X, class Y>
concept no_quotient = written<X> && written<Y> && (strange<X, Y> || no_scalar<Y>);
/// Of two scalars, as an equation is.
template <class X, class Y>
concept no_function = written<X> && written<Y> && (strange<X, Y> || no_scalar<X> || no_scalar<Y>);
template <class X, class Y>
concept no_dot_product =
    written<X> && written<Y> &&
    (no_vector<Y> || (shape_of_operand<X> != shape::vector && shape_of_operand<X> != shape::dyadic));
/// Of two vectors.
template <class X, class Y>
concept no_vectors = written<X> && written<Y> && (no_vector<X> || no_vector<Y>);

/// An equation has lost its sign; of other operands the reader can say what they are.
template <template <int> class Kind, class X>
constexpr auto meaningless(const X& x, const token& last) {
  return followed_by<Kind>(operand(x).tokens, equates<X, X> ? misused(misuse::inner_equation) : last);
}
template <template <int> class Kind, class X, class Y>
constexpr auto meaningless(const X& x, const Y& y, const token& last) {
  return followed_by<Kind>(operand(x).tokens, operand(y).tokens,
                           equates<X, Y> ? misused(misuse::inner_equation) : last);
}

} // namespace describe

template <class X, class Y>
  requires describe::no_sum<X, Y>
constexpr auto operator+(const X& x, const Y& y) {
  return describe::meaningless<vector>(x, y, describe::with(describe::token_kind::add));
}
template <class X, class Y>
  requires describe::no_sum<X, Y>
constexpr auto operator-(const X& x, const Y& y) {
  return describe::meaningless<vector>(x, y, describe::with(describe::token_kind::subtract));
}
template <class X, class Y>
  requires describe::no_product<X, Y>
constexpr auto operator*(const X& x, const Y& y) {
  return describe::meaningless<vector>(x, y, describe::with(describe::token_kind::multiply));
}
template <class X, class Y>
  requires describe::no_quotient<X, Y>
constexpr auto operator/(const X& x, const Y& y) {
  return describe::meaningless<vector>(x, y, describe::with(describe::token_kind::divide));
}
template <class X, class Y>
  requires describe::no_function<X, Y>
constexpr auto operator==(const X& x, const Y& y) {
  return describe::meaningless<equation>(x, y, describe::with(describe::token_kind::subtract));
}
template <int a>
constexpr auto operator-(const equation<a>& e) {
  return describe::meaningless<vector>(e, describe::with(describe::token_kind::negate));
}

template <class X, class Y>
  requires describe::no_dot_product<X, Y>
constexpr auto dot(const X& x, const Y& y) {
  return describe::meaningless<scalar>(x, y, describe::with(describe::token_kind::dot));
}
template <class X, class Y>
  requires describe::no_vectors<X, Y>
constexpr auto cross(const X& x, const Y& y) {
  return describe::meaningless<vector>(x, y, describe::with(describe::token_kind::cross));
}
template <class X, class Y>
  requires describe::no_vectors<X, Y>
constexpr auto outer(const X& x, const Y& y) {
  return describe::meaningless<dyadic>(x, y, describe::with(describe::token_kind::outer));
}
template <describe::no_vector X>
constexpr auto magnitude(const X& x) {
  return describe::meaningless<scalar>(x, describe::with(describe::token_kind::magnitude));
}
template <describe::no_vector X>
constexpr auto normalized(const X& x) {
  return describe::meaningless<vector>(x, describe::with(describe::token_kind::normalized));
}

} // namespace kanexpr
