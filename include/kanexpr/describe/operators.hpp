#pragma once

#include <kanexpr/describe/operand.hpp>

/// The operators and products of expressions. They accept operands of any kind, because only the reader of
/// the model can report a mismatch together with the entity to which it belongs.
namespace kanexpr {

namespace describe {

template <class Left, class Right>
constexpr auto sum(token_kind what, const Left& x, const Right& y) {
  constexpr shape kind = shape_of_operand<Left>;
  if constexpr (are_quantities<Left, Right> && kind == shape_of_operand<Right>)
    return joined<kind>(with(what), operand(x), operand(y));
  else
    return as_written<shape::vector>(with(what), x, y);
}

/// The product of a scalar and any quantity, stored in this order.
template <class Left, class Right>
constexpr auto product(const Left& x, const Right& y) {
  constexpr shape left = shape_of_operand<Left>, right = shape_of_operand<Right>;
  constexpr bool fits = are_quantities<Left, Right> && (left == shape::scalar || right == shape::scalar);
  const bool is_zero = fits && (is_whole_zero(x) || is_whole_zero(y));
  if constexpr (fits && left != shape::scalar)
    return product(y, x);
  else
    return as_written<fits ? right : shape::vector>(
        is_zero ? misused(misuse::zero_factor) : with(token_kind::multiply), x, y);
}

template <class Left, class Right>
constexpr auto quotient(const Left& x, const Right& y) {
  constexpr bool fits = are_quantities<Left, Right> && are_scalars<Right>;
  return as_written<fits ? shape_of_operand<Left> : shape::vector>(
      fits && is_whole_zero(x) ? misused(misuse::zero_factor) : with(token_kind::divide), x, y);
}

/// A side of an equation, which may be 0; the value reader rejects a parameter that is bound to 0.
template <class Operand>
constexpr auto side(const Operand& x) {
  auto given = operand_or_zero(x);
  if (is_whole_zero(x)) given.tokens[0].index = whole_zero;
  return given;
}

template <class Left, class Right>
constexpr auto equated(const Left& x, const Right& y) {
  if constexpr (are_quantities<Left, Right> && are_scalars<Left, Right>)
    return joined<shape::equation>(with(token_kind::subtract), side(x), side(y));
  else
    return as_written<shape::equation>(with(token_kind::subtract), x, y);
}

} // namespace describe

template <describe::expression_of_a_model Operand>
constexpr auto operator-(const Operand& x) {
  constexpr describe::shape kind = describe::shape_of_operand<Operand>;
  return describe::as_written < kind == describe::shape::equation
             ? describe::shape::vector
             : kind > (describe::with(describe::token_kind::negate), x);
}
template <describe::expression_of_a_model Operand>
constexpr const Operand& operator+(const Operand& x) {
  return x;
}

template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator+(const Left& x, const Right& y) {
  return describe::sum(describe::token_kind::add, x, y);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator-(const Left& x, const Right& y) {
  return describe::sum(describe::token_kind::subtract, x, y);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator*(const Left& x, const Right& y) {
  return describe::product(x, y);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator/(const Left& x, const Right& y) {
  return describe::quotient(x, y);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator==(const Left& x, const Right& y) {
  return describe::equated(x, y);
}

/// The scalar product of two vectors, or the vector d·v of a dyadic and a vector.
template <describe::written Left, describe::written Right>
constexpr auto dot(const Left& x, const Right& y) {
  using describe::shape;
  constexpr bool gives_vector =
      describe::shape_of_operand<Left> == shape::dyadic && describe::shape_of_operand<Right> == shape::vector;
  return describe::as_written<gives_vector ? shape::vector : shape::scalar>(
      describe::with(describe::token_kind::dot), x, y);
}
/// The vector product v × w of two vectors.
template <describe::written Left, describe::written Right>
constexpr auto cross(const Left& x, const Right& y) {
  return describe::as_written<describe::shape::vector>(describe::with(describe::token_kind::cross), x, y);
}
/// The dyad v ⊗ w.
template <describe::written Left, describe::written Right>
constexpr auto outer(const Left& x, const Right& y) {
  return describe::as_written<describe::shape::dyadic>(describe::with(describe::token_kind::outer), x, y);
}
/// The magnitude |v| of a vector; its derivative is undefined where the vector vanishes.
template <describe::written Operand>
constexpr auto magnitude(const Operand& x) {
  return describe::as_written<describe::shape::scalar>(describe::with(describe::token_kind::magnitude), x);
}
/// The unit vector along `v`.
template <describe::written Operand>
constexpr auto normalized(const Operand& v) {
  return describe::as_written<describe::shape::vector>(describe::with(describe::token_kind::normalized), v);
}

} // namespace kanexpr
