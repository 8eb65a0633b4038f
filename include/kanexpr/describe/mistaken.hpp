#pragma once

#include <kanexpr/describe/operand.hpp>

/// Operators that C++ has and models do not, such as `dot(q) = u` and `q^2`. What is written
/// with them is kept, with the mistake behind it: who reads the model knows where it stands, and says so.
namespace kanexpr {

namespace describe {

template <class X>
concept expression_of_a_model = written<X> && std::is_class_v<X>;
template <class X, class Y>
concept operands_of_a_model = written<X> && written<Y> && (std::is_class_v<X> || std::is_class_v<Y>);

template <template <int> class Kind, class X>
constexpr auto misused(const X& x, misuse what) {
  return followed_by<Kind>(operand(x).tokens, misused(what));
}
template <template <int> class Kind, class X, class Y>
constexpr auto misused(const X& x, const Y& y, misuse what) {
  return followed_by<Kind>(operand(x).tokens, operand(y).tokens, misused(what));
}

template <class X, class Y>
constexpr auto assigned(const X& x, const Y& y) {
  return misused<equation>(x, y, misuse::assignment);
}
template <class X>
constexpr auto with_index(const X& x) {
  return misused<scalar>(x, misuse::index);
}
template <class X>
constexpr auto with_arguments(const X& x) {
  return misused<scalar>(x, misuse::arguments);
}

} // namespace describe

template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator!=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator<(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator>(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator<=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator>=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator<=>(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::comparison);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator^(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::caret);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator%(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::remainder);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator&(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::bits);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator|(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::bits);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator<<(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::bits);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator>>(const X& x, const Y& y) {
  return describe::misused<scalar>(x, y, describe::misuse::bits);
}
template <describe::expression_of_a_model X>
constexpr auto operator!(const X& x) {
  return describe::misused<equation>(x, describe::misuse::denial);
}
template <describe::expression_of_a_model X>
constexpr auto operator~(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::bits);
}
template <describe::expression_of_a_model X>
constexpr auto operator*(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::bits);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator+=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator-=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator*=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator/=(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::change);
}

// To g++'s -Weffc++ each of these is a mistake by its mere existence, and no other form of them says a
// sentence.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator&&(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::junction);
}
template <class X, class Y>
  requires describe::operands_of_a_model<X, Y>
constexpr auto operator||(const X& x, const Y& y) {
  return describe::misused<equation>(x, y, describe::misuse::junction);
}
template <describe::expression_of_a_model X>
constexpr auto operator++(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model X>
constexpr auto operator++(const X& x, int) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model X>
constexpr auto operator--(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
template <describe::expression_of_a_model X>
constexpr auto operator--(const X& x, int) {
  return describe::misused<scalar>(x, describe::misuse::change);
}
#pragma GCC diagnostic pop

template <describe::expression_of_a_model X>
constexpr auto dot(const X& x) {
  return describe::misused<scalar>(x, describe::misuse::rate);
}

template <describe::expression_of_a_model X, class Y, class Z, class... More>
constexpr auto dot(const X& x, const Y&, const Z&, const More&...) {
  return describe::misused<scalar>(x, describe::misuse::operands);
}
template <describe::expression_of_a_model X, class Y, class Z, class... More>
constexpr auto cross(const X& x, const Y&, const Z&, const More&...) {
  return describe::misused<vector>(x, describe::misuse::operands);
}

} // namespace kanexpr
