#pragma once

#include <kanexpr/describe/operand.hpp>

/// Expressions whose operands are of incompatible kinds, such as `u1 + N::x`. They are stored as written, so
/// that the reader of the model can report them with the point or frame to which they belong.
namespace kanexpr {

namespace describe {

template <class Left, class Right>
inline constexpr bool equates =
    shape_of_operand<Left> == shape::equation || shape_of_operand<Right> == shape::equation;
/// True if an operand is not a quantity at all.
template <class Left, class Right>
inline constexpr bool is_no_quantity = equates<Left, Right> || std::same_as<Left, bool> ||
                                       std::same_as<Right, bool> || base::letter<Left> || base::letter<Right>;

template <class Left, class Right>
concept no_sum = written<Left> && written<Right> &&
                 (is_no_quantity<Left, Right> || shape_of_operand<Left> != shape_of_operand<Right>);
template <class Left, class Right>
concept no_product =
    written<Left> && written<Right> && (is_no_quantity<Left, Right> || (no_scalar<Left> && no_scalar<Right>));
template <class Left, class Right>
concept no_quotient = written<Left> && written<Right> && (is_no_quantity<Left, Right> || no_scalar<Right>);
/// Excludes pairs of scalars; equations are treated in the same way.
template <class Left, class Right>
concept no_function =
    written<Left> && written<Right> && (is_no_quantity<Left, Right> || no_scalar<Left> || no_scalar<Right>);
template <class Left, class Right>
concept no_dot_product = written<Left> && written<Right> &&
                         (no_vector<Right> || (shape_of_operand<Left> != shape::vector &&
                                               shape_of_operand<Left> != shape::dyadic));
/// Excludes pairs of vectors.
template <class Left, class Right>
concept no_vectors = written<Left> && written<Right> && (no_vector<Left> || no_vector<Right>);

/// Stores the operation as written. An equation no longer contains its ==, so it gets a separate mistake; the
/// reader describes operands of other kinds.
template <template <int> class Kind, class Operand>
constexpr auto mismatched(const Operand& x, const token& last) {
  return followed_by<Kind>(operand(with_zeros(x)).tokens,
                           equates<Operand, Operand> ? misused(misuse::inner_equation) : last);
}
template <template <int> class Kind, class Left, class Right>
constexpr auto mismatched(const Left& x, const Right& y, const token& last) {
  return followed_by<Kind>(operand(with_zeros(x)).tokens, operand(with_zeros(y)).tokens,
                           equates<Left, Right> ? misused(misuse::inner_equation) : last);
}

} // namespace describe

template <class Left, class Right>
  requires describe::no_sum<Left, Right>
constexpr auto operator+(const Left& x, const Right& y) {
  return describe::mismatched<vector>(x, y, describe::with(describe::token_kind::add));
}
template <class Left, class Right>
  requires describe::no_sum<Left, Right>
constexpr auto operator-(const Left& x, const Right& y) {
  return describe::mismatched<vector>(x, y, describe::with(describe::token_kind::subtract));
}
template <class Left, class Right>
  requires describe::no_product<Left, Right>
constexpr auto operator*(const Left& x, const Right& y) {
  return describe::mismatched<vector>(x, y, describe::with(describe::token_kind::multiply));
}
template <class Left, class Right>
  requires describe::no_quotient<Left, Right>
constexpr auto operator/(const Left& x, const Right& y) {
  return describe::mismatched<vector>(x, y, describe::with(describe::token_kind::divide));
}
template <class Left, class Right>
  requires describe::no_function<Left, Right>
constexpr auto operator==(const Left& x, const Right& y) {
  return describe::mismatched<equation>(x, y, describe::with(describe::token_kind::subtract));
}
template <int size>
constexpr auto operator-(const equation<size>& e) {
  return describe::mismatched<vector>(e, describe::with(describe::token_kind::negate));
}

template <class Left, class Right>
  requires describe::no_dot_product<Left, Right>
constexpr auto dot(const Left& x, const Right& y) {
  return describe::mismatched<scalar>(x, y, describe::with(describe::token_kind::dot));
}
template <class Left, class Right>
  requires describe::no_vectors<Left, Right>
constexpr auto cross(const Left& x, const Right& y) {
  return describe::mismatched<vector>(x, y, describe::with(describe::token_kind::cross));
}
template <class Left, class Right>
  requires describe::no_vectors<Left, Right>
constexpr auto outer(const Left& x, const Right& y) {
  return describe::mismatched<dyadic>(x, y, describe::with(describe::token_kind::outer));
}
template <describe::no_vector Operand>
constexpr auto magnitude(const Operand& x) {
  return describe::mismatched<scalar>(x, describe::with(describe::token_kind::magnitude));
}
template <describe::no_vector Operand>
constexpr auto normalized(const Operand& x) {
  return describe::mismatched<vector>(x, describe::with(describe::token_kind::normalized));
}

} // namespace kanexpr
