#pragma once

#include <kanexpr/describe/operand.hpp>

#include <type_traits>

/// Operators that C++ has but models do not, such as `dot(q) = u` and `q^2`. The operands are kept, followed
/// by the mistake, so that the reader of the model can report it with its location.
namespace kanexpr {

namespace describe {

template <class Operand>
concept expression_of_a_model = written<Operand> && std::is_class_v<Operand>;
template <class Left, class Right>
concept operands_of_a_model =
    written<Left> && written<Right> && (std::is_class_v<Left> || std::is_class_v<Right>);

template <template <int> class Kind, class Operand>
constexpr auto misused(const Operand& x, misuse what) {
  return followed_by<Kind>(operand(with_zeros(x)).tokens, misused(what));
}
template <template <int> class Kind, class Left, class Right>
constexpr auto misused(const Left& x, const Right& y, misuse what) {
  return followed_by<Kind>(operand(with_zeros(x)).tokens, operand(with_zeros(y)).tokens, misused(what));
}

template <class Left, class Right>
constexpr auto assigned(const Left& x, const Right& y) {
  return misused<equation>(x, y, misuse::assignment);
}
template <class Operand>
constexpr auto with_index(const Operand& x) {
  return misused<scalar>(x, misuse::index);
}
template <class Operand>
constexpr auto with_arguments(const Operand& x) {
  return misused<scalar>(x, misuse::arguments);
}

} // namespace describe

template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator!=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator<(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator>(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator<=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator>=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator<=>(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator^(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::caret);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator%(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::remainder);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator&(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::unsupported_operator);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator|(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::unsupported_operator);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator<<(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::unsupported_operator);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator>>(const Left& x, const Right& y) {
  return describe::misused<scalar>(x, y, describe::misuse::unsupported_operator);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator!(const Operand& x) {
  return describe::misused<equation>(x, describe::misuse::negation);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator~(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::unsupported_operator);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator*(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::unsupported_operator);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator+=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator-=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator*=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator/=(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}

// g++'s -Weffc++ warns about the mere existence of these operators, but only they allow an error sentence.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator&&(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::logical_operator);
}
template <class Left, class Right>
  requires describe::operands_of_a_model<Left, Right>
constexpr auto operator||(const Left& x, const Right& y) {
  return describe::misused<equation>(x, y, describe::misuse::logical_operator);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator++(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator++(const Operand& x, int) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator--(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator--(const Operand& x, int) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
#pragma GCC diagnostic pop

template <describe::expression_of_a_model Operand>
constexpr auto dot(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::rate);
}

template <describe::expression_of_a_model Left, class Right, class Third, class... More>
constexpr auto dot(const Left& x, const Right&, const Third&, const More&...) {
  return describe::misused<scalar>(x, describe::misuse::operands);
}
template <describe::expression_of_a_model Left, class Right, class Third, class... More>
constexpr auto cross(const Left& x, const Right&, const Third&, const More&...) {
  return describe::misused<vector>(x, describe::misuse::operands);
}

} // namespace kanexpr
