#pragma once

#include <type_traits>

/// Iterates over the members of an aggregate, so that an operation on all members need not name them.
namespace kanexpr {

namespace detail {

/// An initializer that converts to a member of any type.
struct any_member {
  template <class Member>
  constexpr operator Member() const;
};

template <class Whole, class... Members>
consteval int member_count() {
  if constexpr (requires { Whole{Members{}..., any_member{}}; })
    return member_count<Whole, Members..., any_member>();
  else
    return static_cast<int>(sizeof...(Members));
}

template <class Whole, class Visit>
constexpr void for_each_bound_member(Whole& whole, Visit& visit) {
  constexpr int count = detail::member_count<std::remove_const_t<Whole>>();
  static_assert(count > 0 && count <= 14);
  const auto each = [&](auto&... member) { (visit(member), ...); };
  if constexpr (count == 1) {
    auto& [a] = whole;
    each(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = whole;
    each(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = whole;
    each(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = whole;
    each(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = whole;
    each(a, b, c, d, e);
  } else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = whole;
    each(a, b, c, d, e, f);
  } else if constexpr (count == 7) {
    auto& [a, b, c, d, e, f, g] = whole;
    each(a, b, c, d, e, f, g);
  } else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = whole;
    each(a, b, c, d, e, f, g, h);
  } else if constexpr (count == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = whole;
    each(a, b, c, d, e, f, g, h, i);
  } else if constexpr (count == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = whole;
    each(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (count == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = whole;
    each(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (count == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = whole;
    each(a, b, c, d, e, f, g, h, i, j, k, l);
  } else if constexpr (count == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = whole;
    each(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = whole;
    each(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  }
}

} // namespace detail

/// @internal Calls `visit` with the members that the class lists in `each_member`, or else with each member
/// of an aggregate, in declaration order. At most 14 members of an aggregate are supported.
template <class Whole, class Visit>
constexpr void for_each_member(Whole& whole, Visit&& visit) {
  if constexpr (requires { Whole::each_member(whole, visit); })
    Whole::each_member(whole, visit);
  else
    detail::for_each_bound_member(whole, visit);
}

} // namespace kanexpr
