#pragma once

#include <kanexpr/describe/expression.hpp>

namespace kanexpr {

/// A vector of a model: basis vectors of any frames, mixed freely, as in `u1*L::x + u2*N::y`.
template <int size>
struct vector {
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

/// A sum of products of vectors, as in `Ixx*outer(L::x, L::x)`.
template <int size>
struct dyadic {
  describe::token tokens[static_cast<std::size_t>(size)];
};

template <int a>
constexpr vector<a + 1> operator-(const vector<a>& v) {
  return describe::join<vector<a + 1>>(v.tokens, describe::with(describe::token_kind::negate));
}
template <int a>
constexpr const vector<a>& operator+(const vector<a>& v) {
  return v;
}
template <int a, int b>
constexpr vector<a + b + 1> operator+(const vector<a>& v, const vector<b>& w) {
  return describe::join<vector<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::token_kind::add));
}
template <int a, int b>
constexpr vector<a + b + 1> operator-(const vector<a>& v, const vector<b>& w) {
  return describe::join<vector<a + b + 1>>(v.tokens, w.tokens,
                                           describe::with(describe::token_kind::subtract));
}
template <int a, int b>
constexpr vector<a + b + 1> operator*(const scalar<a>& s, const vector<b>& v) {
  return describe::join<vector<a + b + 1>>(s.tokens, v.tokens,
                                           describe::with(describe::token_kind::multiply));
}
template <int a, int b>
constexpr vector<a + b + 1> operator*(const vector<a>& v, const scalar<b>& s) {
  return s * v;
}
template <int a, int b>
constexpr vector<a + b + 1> operator/(const vector<a>& v, const scalar<b>& s) {
  return describe::join<vector<a + b + 1>>(v.tokens, s.tokens, describe::with(describe::token_kind::divide));
}
template <describe::plain_number T, int b>
constexpr auto operator*(T s, const vector<b>& v) {
  return describe::constant(s) * v;
}
template <int a, describe::plain_number T>
constexpr auto operator*(const vector<a>& v, T s) {
  return describe::constant(s) * v;
}
template <int a, describe::plain_number T>
constexpr auto operator/(const vector<a>& v, T s) {
  return v / describe::constant(s);
}

template <int a, int b>
constexpr scalar<a + b + 1> dot(const vector<a>& v, const vector<b>& w) {
  return describe::join<scalar<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::token_kind::dot));
}
template <int a, int b>
constexpr vector<a + b + 1> cross(const vector<a>& v, const vector<b>& w) {
  return describe::join<vector<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::token_kind::cross));
}
template <int a>
constexpr scalar<a + 1> magnitude(const vector<a>& v) {
  return describe::join<scalar<a + 1>>(v.tokens, describe::with(describe::token_kind::magnitude));
}
/// The unit vector along `v`.
template <int a>
constexpr vector<a + 1> normalized(const vector<a>& v) {
  return describe::join<vector<a + 1>>(v.tokens, describe::with(describe::token_kind::normalized));
}

/// The dyad v ⊗ w.
template <int a, int b>
constexpr dyadic<a + b + 1> outer(const vector<a>& v, const vector<b>& w) {
  return describe::join<dyadic<a + b + 1>>(v.tokens, w.tokens, describe::with(describe::token_kind::outer));
}
template <int a>
constexpr dyadic<a + 1> operator-(const dyadic<a>& d) {
  return describe::join<dyadic<a + 1>>(d.tokens, describe::with(describe::token_kind::negate));
}
template <int a, int b>
constexpr dyadic<a + b + 1> operator+(const dyadic<a>& d, const dyadic<b>& e) {
  return describe::join<dyadic<a + b + 1>>(d.tokens, e.tokens, describe::with(describe::token_kind::add));
}
template <int a, int b>
constexpr dyadic<a + b + 1> operator-(const dyadic<a>& d, const dyadic<b>& e) {
  return describe::join<dyadic<a + b + 1>>(d.tokens, e.tokens,
                                           describe::with(describe::token_kind::subtract));
}
template <int a, int b>
constexpr dyadic<a + b + 1> operator*(const scalar<a>& s, const dyadic<b>& d) {
  return describe::join<dyadic<a + b + 1>>(s.tokens, d.tokens,
                                           describe::with(describe::token_kind::multiply));
}
template <int a, int b>
constexpr dyadic<a + b + 1> operator*(const dyadic<a>& d, const scalar<b>& s) {
  return s * d;
}
template <describe::plain_number T, int b>
constexpr auto operator*(T s, const dyadic<b>& d) {
  return describe::constant(s) * d;
}
template <int a, describe::plain_number T>
constexpr auto operator*(const dyadic<a>& d, T s) {
  return describe::constant(s) * d;
}
template <int a, int b>
constexpr dyadic<a + b + 1> operator/(const dyadic<a>& d, const scalar<b>& s) {
  return describe::join<dyadic<a + b + 1>>(d.tokens, s.tokens, describe::with(describe::token_kind::divide));
}
template <int a, describe::plain_number T>
constexpr auto operator/(const dyadic<a>& d, T s) {
  return d / describe::constant(s);
}
/// The vector d·v.
template <int a, int b>
constexpr vector<a + b + 1> dot(const dyadic<a>& d, const vector<b>& v) {
  return describe::join<vector<a + b + 1>>(d.tokens, v.tokens, describe::with(describe::token_kind::dot));
}

} // namespace kanexpr
