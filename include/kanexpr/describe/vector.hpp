#pragma once

#include <kanexpr/describe/expression.hpp>

namespace kanexpr {

/// A vector of a model: a combination of basis vectors of any frames, as in `u1*L::x + u2*N::y`.
template <int size>
struct vector {
  describe::token tokens[static_cast<std::size_t>(size)];

  template <class Right>
  constexpr auto operator=(const Right& other) const {
    return describe::assigned(*this, other);
  }
  template <class Index>
  constexpr auto operator[](const Index&) const {
    return describe::with_index(*this);
  }
  template <class... Arguments>
  constexpr auto operator()(const Arguments&...) const {
    return describe::with_arguments(*this);
  }
};

/// A dyadic, a sum of products of vectors, as in `Ixx*outer(L::x, L::x)`.
template <int size>
struct dyadic {
  describe::token tokens[static_cast<std::size_t>(size)];
};

template <int size>
constexpr vector<size + 1> operator-(const vector<size>& v) {
  return describe::join<vector<size + 1>>(v.tokens, describe::with(describe::token_kind::negate));
}
template <int size>
constexpr const vector<size>& operator+(const vector<size>& v) {
  return v;
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> operator+(const vector<left_size>& v,
                                                       const vector<right_size>& w) {
  return describe::join<vector<left_size + right_size + 1>>(v.tokens, w.tokens,
                                                            describe::with(describe::token_kind::add));
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> operator-(const vector<left_size>& v,
                                                       const vector<right_size>& w) {
  return describe::join<vector<left_size + right_size + 1>>(v.tokens, w.tokens,
                                                            describe::with(describe::token_kind::subtract));
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> operator*(const scalar<left_size>& s,
                                                       const vector<right_size>& v) {
  return describe::join<vector<left_size + right_size + 1>>(s.tokens, v.tokens,
                                                            describe::with(describe::token_kind::multiply));
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> operator*(const vector<left_size>& v,
                                                       const scalar<right_size>& s) {
  return s * v;
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> operator/(const vector<left_size>& v,
                                                       const scalar<right_size>& s) {
  return describe::join<vector<left_size + right_size + 1>>(v.tokens, s.tokens,
                                                            describe::with(describe::token_kind::divide));
}
template <describe::plain_number Number, int size>
constexpr vector<size + 2> operator*(Number s, const vector<size>& v) {
  return describe::join<vector<size + 2>>(
      describe::constant(s).tokens, v.tokens,
      describe::done_with(s, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int size, describe::plain_number Number>
constexpr vector<size + 2> operator*(const vector<size>& v, Number s) {
  return s * v;
}
template <int size, describe::plain_number Number>
constexpr auto operator/(const vector<size>& v, Number s) {
  return v / describe::constant(s);
}

template <int left_size, int right_size>
constexpr scalar<left_size + right_size + 1> dot(const vector<left_size>& v, const vector<right_size>& w) {
  return describe::join<scalar<left_size + right_size + 1>>(v.tokens, w.tokens,
                                                            describe::with(describe::token_kind::dot));
}
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> cross(const vector<left_size>& v, const vector<right_size>& w) {
  return describe::join<vector<left_size + right_size + 1>>(v.tokens, w.tokens,
                                                            describe::with(describe::token_kind::cross));
}
template <int size>
constexpr scalar<size + 1> magnitude(const vector<size>& v) {
  return describe::join<scalar<size + 1>>(v.tokens, describe::with(describe::token_kind::magnitude));
}
/// The unit vector along `v`.
template <int size>
constexpr vector<size + 1> normalized(const vector<size>& v) {
  return describe::join<vector<size + 1>>(v.tokens, describe::with(describe::token_kind::normalized));
}

/// The dyad v ⊗ w.
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> outer(const vector<left_size>& v, const vector<right_size>& w) {
  return describe::join<dyadic<left_size + right_size + 1>>(v.tokens, w.tokens,
                                                            describe::with(describe::token_kind::outer));
}
template <int size>
constexpr dyadic<size + 1> operator-(const dyadic<size>& d) {
  return describe::join<dyadic<size + 1>>(d.tokens, describe::with(describe::token_kind::negate));
}
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> operator+(const dyadic<left_size>& d,
                                                       const dyadic<right_size>& e) {
  return describe::join<dyadic<left_size + right_size + 1>>(d.tokens, e.tokens,
                                                            describe::with(describe::token_kind::add));
}
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> operator-(const dyadic<left_size>& d,
                                                       const dyadic<right_size>& e) {
  return describe::join<dyadic<left_size + right_size + 1>>(d.tokens, e.tokens,
                                                            describe::with(describe::token_kind::subtract));
}
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> operator*(const scalar<left_size>& s,
                                                       const dyadic<right_size>& d) {
  return describe::join<dyadic<left_size + right_size + 1>>(s.tokens, d.tokens,
                                                            describe::with(describe::token_kind::multiply));
}
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> operator*(const dyadic<left_size>& d,
                                                       const scalar<right_size>& s) {
  return s * d;
}
template <describe::plain_number Number, int size>
constexpr dyadic<size + 2> operator*(Number s, const dyadic<size>& d) {
  return describe::join<dyadic<size + 2>>(
      describe::constant(s).tokens, d.tokens,
      describe::done_with(s, describe::token_kind::multiply, describe::misuse::zero_factor));
}
template <int size, describe::plain_number Number>
constexpr dyadic<size + 2> operator*(const dyadic<size>& d, Number s) {
  return s * d;
}
template <int left_size, int right_size>
constexpr dyadic<left_size + right_size + 1> operator/(const dyadic<left_size>& d,
                                                       const scalar<right_size>& s) {
  return describe::join<dyadic<left_size + right_size + 1>>(d.tokens, s.tokens,
                                                            describe::with(describe::token_kind::divide));
}
template <int size, describe::plain_number Number>
constexpr auto operator/(const dyadic<size>& d, Number s) {
  return d / describe::constant(s);
}
/// The vector d·v.
template <int left_size, int right_size>
constexpr vector<left_size + right_size + 1> dot(const dyadic<left_size>& d, const vector<right_size>& v) {
  return describe::join<vector<left_size + right_size + 1>>(d.tokens, v.tokens,
                                                            describe::with(describe::token_kind::dot));
}

} // namespace kanexpr
