#pragma once

#include <kanexpr/symbolic/polynomials/exact_numbers.hpp>

#include <cstdint>
#include <vector>

/// Arithmetic modulo a prime below 2³¹, and univariate polynomials over that field.
namespace kanexpr::symbolic::polynomials {

using residue = std::uint64_t;
/// The coefficients of a univariate polynomial, constant term first; the last is not zero.
using residues = std::vector<residue>;

class prime_field {
public:
  explicit prime_field(residue prime) : prime_(prime) {}

  residue prime() const { return prime_; }
  residue of(const integer& n) const {
    const auto rest = static_cast<residue>(abs(n) % prime_);
    return n < 0 && rest != 0 ? prime_ - rest : rest;
  }
  residue add(residue a, residue b) const { return (a + b) % prime_; }
  residue subtract(residue a, residue b) const { return (a + prime_ - b) % prime_; }
  residue multiply(residue a, residue b) const { return a * b % prime_; }
  residue power(residue base, std::uint64_t exponent) const {
    return power_by_squaring(base, exponent, residue{1},
                             [this](residue a, residue b) { return multiply(a, b); });
  }
  residue inverse(residue a) const { return power(a, prime_ - 2); }

  residue value(const residues& p, residue x) const {
    residue sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = add(multiply(sum, x), p[i]);
    return sum;
  }
  residues scaled(residues p, residue by) const {
    for (residue& c : p) c = multiply(c, by);
    return p;
  }
  /// The monic greatest common divisor.
  residues greatest_common_divisor(residues a, residues b) const {
    while (!b.empty()) {
      reduce(a, b);
      a.swap(b);
    }
    return a.empty() ? a : scaled(a, inverse(a.back()));
  }
  /// Π (x - root).
  residues polynomial_with_roots(const residues& roots) const {
    residues p{1};
    for (residue root : roots) {
      p.insert(p.begin(), 0);
      for (std::size_t i = 0; i + 1 < p.size(); ++i) p[i] = subtract(p[i], multiply(root, p[i + 1]));
    }
    return p;
  }
  /// p/(x - root).
  residues deflate(const residues& p, residue root) const {
    residues quotient(p.size() - 1);
    residue carried = 0;
    for (std::size_t i = p.size() - 1; i > 0; --i)
      carried = quotient[i - 1] = add(p[i], multiply(carried, root));
    return quotient;
  }
  /// The polynomial with the given values at the given points.
  residues interpolated(const residues& places, const residues& values) const {
    const residues all = polynomial_with_roots(places);
    residues sum(places.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const residues others = deflate(all, places[i]);
      const residue weight = multiply(values[i], inverse(value(others, places[i])));
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = add(sum[k], multiply(weight, others[k]));
    }
    return sum;
  }
  /// The c with Σ c_s base_s^t = value_t for t = 1, 2, ... (a transposed Vandermonde system). There may be
  /// more values than needed.
  residues solve_transposed_vandermonde(const residues& bases, const residues& values) const {
    const residues all = polynomial_with_roots(bases);
    residues found;
    for (residue base : bases) {
      const residues others = deflate(all, base);
      residue sum = 0;
      for (std::size_t t = 0; t < others.size(); ++t) sum = add(sum, multiply(others[t], values[t]));
      found.push_back(multiply(sum, inverse(multiply(base, value(others, base)))));
    }
    return found;
  }

private:
  void reduce(residues& a, const residues& b) const {
    const residue by = inverse(b.back());
    while (a.size() >= b.size()) {
      const residue weight = multiply(a.back(), by);
      const std::size_t shift = a.size() - b.size();
      for (std::size_t i = 0; i < b.size(); ++i)
        a[shift + i] = subtract(a[shift + i], multiply(weight, b[i]));
      while (!a.empty() && a.back() == 0) a.pop_back();
    }
  }

  residue prime_;
};

/// The next smaller prime.
inline residue prime_below(residue n) {
  const auto is_prime = [](residue p) {
    for (residue divisor = 3; divisor * divisor <= p; divisor += 2)
      if (p % divisor == 0) return false;
    return p % 2 != 0;
  };
  do --n;
  while (!is_prime(n));
  return n;
}

} // namespace kanexpr::symbolic::polynomials
