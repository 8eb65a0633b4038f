#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::symbolic {

/// Solves systems of order 2 or 3 by cofactors. Minors are formed when needed and shared as equal nodes;
/// structural zeros vanish.
class cofactors {
public:
  /// How the cofactors are used: column by column (Cramer's rule; most cofactors are formed with the
  /// right-hand side), all computed once for any number of right-hand sides, or divided by the determinant
  /// beforehand.
  struct method {
    enum kind { cramer, adjugate, inverse } variant = adjugate;
    int column = 0;          ///< the column along which the determinant is expanded
    bool transposed = false; ///< columns of Aᵀ
  };

  /// The entries are given row by row; `results` is the number of solution components needed.
  constexpr cofactors(graph& g, const sequence<int>& entries, int order, method m, int results)
      : g_(g), a_(entries), n_(order), method_(m) {
    determinant_ = graph::zero;
    for (int i = 0; i < n_; ++i)
      determinant_ =
          add(g_, determinant_, multiply(g_, at(i, m.column, m.transposed), of(i, m.column, m.transposed)));
    divides_ = results == 1 && m.variant != method::inverse;
    if (!divides_ && results > 0) reciprocal_ = divide(g_, graph::one, determinant_);
  }

  constexpr int determinant() const { return determinant_; }

  /// An element of x in A x = b or Aᵀ x = b.
  constexpr int component(const sequence<int>& b, int j, bool transposed) {
    if (method_.variant == method::inverse) {
      int sum = graph::zero;
      for (int i = 0; i < n_; ++i)
        sum = add(g_, sum, multiply(g_, multiply(g_, of(i, j, transposed), reciprocal_), b[i]));
      return sum;
    }
    const int above = numerator(b, j, transposed);
    return divides_ ? divide(g_, above, determinant_) : multiply(g_, above, reciprocal_);
  }

  /// The available methods for a system, its transpose, or both.
  static constexpr sequence<method> all(int order, bool has_plain, bool has_transposed) {
    sequence<method> methods;
    for (int j = 0; j < order; ++j) {
      methods.push({method::adjugate, j, false});
      methods.push({method::inverse, j, false});
      if (order == 3 && has_plain) methods.push({method::cramer, j, false});
      if (order == 3 && has_transposed) methods.push({method::cramer, j, true});
    }
    return methods;
  }

private:
  constexpr int at(int i, int j) const { return a_[(i % n_) * n_ + j % n_]; }
  constexpr int at(int i, int j, bool transposed) const { return transposed ? at(j, i) : at(i, j); }
  /// p s - q r
  constexpr int minor_of(int p, int q, int r, int s) {
    const int product = multiply(g_, p, s);
    return subtract(g_, product, multiply(g_, q, r));
  }

  /// The signed cofactor of an entry.
  constexpr int of(int i, int j, bool transposed) {
    if (transposed) return of(j, i, false);
    if (n_ == 3) return minor_of(at(i + 1, j + 1), at(i + 1, j + 2), at(i + 2, j + 1), at(i + 2, j + 2));
    return i == j ? at(i + 1, j + 1) : negate(g_, at(i + 1, j + 1));
  }

  constexpr int numerator(const sequence<int>& b, int j, bool transposed) {
    int sum = graph::zero;
    if (method_.variant == method::adjugate || j == method_.column) {
      for (int i = 0; i < 3 && i < n_; ++i) sum = add(g_, sum, multiply(g_, b[i], of(i, j, transposed)));
      return sum;
    }
    // if c, j and the third column are in cyclic order, det[c, b, third] = third·(c × b); otherwise the sign
    // changes
    const int c = method_.column, third = 3 - c - j;
    for (int i = 0; i < 3; ++i) {
      const int p = (i + 1) % 3, q = (i + 2) % 3;
      const int normal = minor_of(at(p, c, transposed), b[p], at(q, c, transposed), b[q]);
      sum = add(g_, sum, multiply(g_, at(i, third, transposed), normal));
    }
    return j == (c + 1) % 3 ? sum : negate(g_, sum);
  }

  graph& g_;
  const sequence<int>& a_;
  int n_ = 0;
  method method_;
  int determinant_ = graph::zero;
  int reciprocal_ = graph::zero;
  bool divides_ = false;
};

/// The largest order for which the determinant is expanded; beyond it, the expression would be long.
inline constexpr int largest_with_determinant = 6;

/// The determinant of a matrix stored in row-major order, expanded along its first row. Minors are shared as
/// equal nodes, and structural zeros vanish.
constexpr expression determinant(const sequence<expression>& entries, int order) {
  if (order == 1) return entries[0];
  expression sum = entries[0] - entries[0];
  for (int j = 0; j < order; ++j) {
    if (entries[j].is_zero()) continue;
    sequence<expression> rest;
    for (int i = 1; i < order; ++i)
      for (int k = 0; k < order; ++k)
        if (k != j) rest.push(entries[i * order + k]);
    const expression minor = determinant(rest, order - 1);
    const expression term = entries[j] * minor;
    sum = j % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

} // namespace kanexpr::symbolic
