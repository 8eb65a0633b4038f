#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

namespace kanexpr::symbolic::polynomials {

/// A power of a node or, if the base is negative, of an exponential; see angle.hpp.
struct factor {
  int base = 0;
  std::int64_t exponent = 0;

  bool operator==(const factor&) const = default;
};

/// Π base^exponent with ascending bases and nonzero exponents, which may be negative.
using monomial = std::vector<factor>;

/// The largest exponent allowed in a polynomial.
inline constexpr std::int64_t largest_exponent = std::int64_t{1} << 60;

/// Calls `visit(base, exponent in a, exponent in b)` for each base in either monomial, in ascending order.
template <class Visit>
void visit_both(const monomial& a, const monomial& b, Visit visit) {
  auto x = a.begin(), y = b.begin();
  while (x != a.end() || y != b.end()) {
    const bool in_a = x != a.end() && (y == b.end() || x->base <= y->base);
    const bool in_b = y != b.end() && (x == a.end() || y->base <= x->base);
    visit(in_a ? x->base : y->base, in_a ? x->exponent : 0, in_b ? y->exponent : 0);
    if (in_a) ++x;
    if (in_b) ++y;
  }
}

/// a b^weight.
inline monomial times(const monomial& a, const monomial& b, std::int64_t weight = 1) {
  monomial product;
  product.reserve(a.size() + b.size());
  visit_both(a, b, [&](int base, std::int64_t i, std::int64_t j) {
    if (i + weight * j != 0) product.push_back({base, i + weight * j});
  });
  return product;
}
inline monomial over(const monomial& a, const monomial& b) { return times(a, b, -1); }

/// The largest monomial that divides both.
inline monomial common_part(const monomial& a, const monomial& b) {
  monomial common;
  visit_both(a, b, [&](int base, std::int64_t i, std::int64_t j) {
    if ((std::min)(i, j) != 0) common.push_back({base, (std::min)(i, j)});
  });
  return common;
}

inline std::int64_t exponent_of(const monomial& m, int base) {
  const auto place = std::ranges::lower_bound(m, base, {}, &factor::base);
  return place != m.end() && place->base == base ? place->exponent : 0;
}

inline monomial without(monomial m, int base) {
  std::erase_if(m, [base](const factor& f) { return f.base == base; });
  return m;
}

/// The lexicographic order of exponents, which multiplication preserves.
inline std::strong_ordering compare(const monomial& a, const monomial& b) {
  const auto [x, y] = std::ranges::mismatch(a, b);
  const bool in_a = x != a.end() && (y == b.end() || x->base <= y->base);
  const bool in_b = y != b.end() && (x == a.end() || y->base <= x->base);
  return (in_a ? x->exponent : 0) <=> (in_b ? y->exponent : 0);
}

struct descending {
  bool operator()(const monomial& a, const monomial& b) const { return compare(a, b) > 0; }
};

struct monomial_hash {
  std::size_t operator()(const monomial& m) const {
    std::uint64_t mixed = 0;
    for (const factor& f : m) {
      mixed = (mixed ^ static_cast<std::uint32_t>(f.base)) * 0x9e3779b97f4a7c15u;
      mixed = (mixed ^ static_cast<std::uint64_t>(f.exponent)) * 0xff51afd7ed558ccdu;
      mixed ^= mixed >> 29;
    }
    return std::hash<std::uint64_t>{}(mixed);
  }
};

} // namespace kanexpr::symbolic::polynomials
