#pragma once

#include <kanexpr/describe/vector.hpp>

/// Expressions that mean nothing, such as `u1 + N::x`. They are kept as they stand: who reads the model knows
/// which point or frame they belong to, and says so.
namespace kanexpr {

template <int a, int b>
constexpr auto operator+(const scalar<a>& s, const vector<b>& v) {
  return describe::join<vector<a + b + 1>>(s.tokens, v.tokens, describe::with(describe::word::add));
}
template <int a, int b>
constexpr auto operator+(const vector<a>& v, const scalar<b>& s) {
  return describe::join<vector<a + b + 1>>(v.tokens, s.tokens, describe::with(describe::word::add));
}
template <int a, int b>
constexpr auto operator-(const scalar<a>& s, const vector<b>& v) {
  return describe::join<vector<a + b + 1>>(s.tokens, v.tokens, describe::with(describe::word::subtract));
}
template <int a, int b>
constexpr auto operator-(const vector<a>& v, const scalar<b>& s) {
  return describe::join<vector<a + b + 1>>(v.tokens, s.tokens, describe::with(describe::word::subtract));
}
template <int a, describe::plain_number T>
constexpr auto operator+(const vector<a>& v, T x) {
  return v + describe::constant(x);
}
template <describe::plain_number T, int b>
constexpr auto operator+(T x, const vector<b>& v) {
  return describe::constant(x) + v;
}
template <int a, describe::plain_number T>
constexpr auto operator-(const vector<a>& v, T x) {
  return v - describe::constant(x);
}
template <describe::plain_number T, int b>
constexpr auto operator-(T x, const vector<b>& v) {
  return describe::constant(x) - v;
}

template <int a, int b>
constexpr auto operator*(const vector<a>& v, const vector<b>& w) {
  return describe::join<vector<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::word::multiply));
}
template <int a, int b>
constexpr auto operator/(const scalar<a>& s, const vector<b>& v) {
  return describe::join<vector<a + b + 1>>(s.tokens, v.tokens, describe::with(describe::word::divide));
}
template <int a, int b>
constexpr auto operator/(const vector<a>& v, const vector<b>& w) {
  return describe::join<vector<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::word::divide));
}
template <describe::plain_number T, int b>
constexpr auto operator/(T x, const vector<b>& v) {
  return describe::constant(x) / v;
}

template <int a, int b>
constexpr auto operator==(const vector<a>& v, const vector<b>& w) {
  return describe::join<equation<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::word::subtract));
}
template <int a, int b>
constexpr auto operator==(const scalar<a>& s, const vector<b>& v) {
  return describe::join<equation<a + b + 1>>(s.tokens, v.tokens, describe::with(describe::word::subtract));
}
template <int a, int b>
constexpr auto operator==(const vector<a>& v, const scalar<b>& s) {
  return describe::join<equation<a + b + 1>>(v.tokens, s.tokens, describe::with(describe::word::subtract));
}
template <int a, describe::plain_number T>
constexpr auto operator==(const vector<a>& v, T x) {
  return v == describe::constant(x);
}

} // namespace kanexpr
