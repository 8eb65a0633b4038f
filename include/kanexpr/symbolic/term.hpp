#pragma once

#include <kanexpr/symbolic/expression.hpp>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

/// Expressions as people write them: flat sums of flat products. What every printed form starts from.
namespace kanexpr::symbolic::printing {

struct factor {
  int base = 0;
  std::int64_t exponent = 1;

  auto operator<=>(const factor&) const = default;
};

/// coefficient · Π base^exponent, the factors in the order in which they are written.
struct term {
  number coefficient = exactly(1);
  std::vector<factor> factors;
};

/// The numerator or the denominator of a term: only positive numbers and exponents.
struct side {
  number coefficient = exactly(1);
  std::vector<factor> factors;

  bool shows_number() const { return coefficient != exactly(1) || factors.empty(); }
  bool is_one() const { return coefficient == exactly(1) && factors.empty(); }
  std::size_t size() const { return factors.size() + (shows_number() ? 1u : 0u); }
};

inline number magnitude(const number& n) { return n.negative() ? -n : n; }

inline side numerator(const term& t) {
  const number c = magnitude(t.coefficient);
  side above{c.exact() ? exactly(c.numerator) : c, {}};
  for (const factor& f : t.factors)
    if (f.exponent > 0) above.factors.push_back(f);
  return above;
}

inline side denominator(const term& t) {
  side below{exactly(t.coefficient.exact() ? t.coefficient.denominator : 1), {}};
  for (const factor& f : t.factors)
    if (f.exponent < 0) below.factors.push_back({f.base, -f.exponent});
  return below;
}

inline bool is_function(operation op) { return *function_name(op) != '\0'; }

/// Breaks a node into weighted parts, which `expand` names; each node is met once, with all of its weight,
/// since users come after their operands. Returns the parts that cannot be broken, by node.
template <class Weight, class Expand>
std::map<int, Weight> gather(int root, const Weight& unit, Expand expand) {
  std::map<int, Weight> parts;
  std::map<int, Weight, std::greater<>> pending{{root, unit}};
  const auto put = [&pending](int id, const Weight& weight) {
    const auto [place, is_new] = pending.try_emplace(id, weight);
    if (!is_new) place->second = place->second + weight;
  };
  while (!pending.empty()) {
    const auto [id, weight] = *pending.begin();
    pending.erase(pending.begin());
    if (!expand(id, weight, put)) parts.emplace(id, weight);
  }
  return parts;
}

inline number integer_power(number base, std::int64_t exponent) {
  if (exponent < 0) base = exactly(1) / base, exponent = -exponent;
  number result = exactly(1);
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base;
    base = base * base;
  }
  return result;
}

/// The names q2 and q10 in this order.
inline std::strong_ordering compare_names(std::string_view a, std::string_view b) {
  const auto letters = [](std::string_view text) { return text.find_last_not_of("0123456789") + 1; };
  const std::size_t i = letters(a), j = letters(b);
  if (const auto order = a.substr(0, i) <=> b.substr(0, j); order != 0) return order;
  if (a.size() != b.size()) return a.size() <=> b.size();
  return a <=> b;
}

/// Where a factor stands: parameters, other symbols, general powers, functions, and at last what needs
/// parentheses.
inline int rank(const graph& g, int id) {
  const operation op = g[id].op;
  if (op == operation::symbol) return g.symbol_at(id).kind == symbol_kind::parameter ? 0 : 1;
  return op == operation::power ? 2 : is_function(op) ? 3 : 4;
}

inline bool stands_before(const graph& g, int a, int b) {
  const int p = rank(g, a), q = rank(g, b);
  if (p != q) return p < q;
  const node &x = g[a], &y = g[b];
  if (is_function(x.op) && is_function(y.op)) {
    if (x.op != y.op) return x.op < y.op;
    return x.a != y.a ? stands_before(g, x.a, y.a) : a < b;
  }
  if (x.op == operation::symbol && y.op == operation::symbol) {
    const auto order = compare_names(g.symbol_at(a).called.view(), g.symbol_at(b).called.view());
    if (order != 0) return order < 0;
    return g.symbol_at(a).kind < g.symbol_at(b).kind;
  }
  return a < b;
}

/// A node as one product.
inline term product_of(const graph& g, int root) {
  constexpr std::int64_t largest_exponent = std::int64_t{1} << 30;
  term product;
  const auto expand = [&](int id, std::int64_t exponent, const auto& put) {
    if (exponent > largest_exponent || exponent < -largest_exponent) return false;
    const node& n = g[id];
    switch (n.op) {
    case operation::constant:
      if (id == graph::zero && exponent < 0) return false;
      product.coefficient = product.coefficient * integer_power(g.number_at(id), exponent);
      return true;
    case operation::negate:
      if (exponent % 2 != 0) product.coefficient = -product.coefficient;
      put(n.a, exponent);
      return true;
    case operation::multiply:
      put(n.a, exponent);
      put(n.b, exponent);
      return true;
    case operation::divide:
      put(n.a, exponent);
      put(n.b, -exponent);
      return true;
    default:
      return false;
    }
  };
  for (const auto& [base, exponent] : gather(root, std::int64_t{1}, expand))
    if (exponent != 0) product.factors.push_back({base, exponent});
  std::ranges::sort(product.factors,
                    [&g](const factor& a, const factor& b) { return stands_before(g, a.base, b.base); });
  return product;
}

/// A node as a sum, never empty: in the order in which the terms were built, numbers last, but a positive
/// term first.
inline std::vector<term> terms_of(const graph& g, int root) {
  const auto expand = [&g](int id, const number& weight, const auto& put) {
    const node& n = g[id];
    if (n.op != operation::add && n.op != operation::subtract && n.op != operation::negate) return false;
    put(n.a, n.op == operation::negate ? -weight : weight);
    if (is_binary(n.op)) put(n.b, n.op == operation::subtract ? -weight : weight);
    return true;
  };
  std::vector<term> sum;
  std::map<std::vector<factor>, std::size_t> places;
  for (const auto& [id, weight] : gather(root, exactly(1), expand)) {
    term t = product_of(g, id);
    t.coefficient = t.coefficient * weight;
    const auto [place, is_new] = places.try_emplace(t.factors, sum.size());
    if (is_new)
      sum.push_back(t);
    else
      sum[place->second].coefficient = sum[place->second].coefficient + t.coefficient;
  }
  std::erase_if(sum, [](const term& t) { return t.coefficient == exactly(0); });
  if (sum.empty()) sum.push_back({exactly(0), {}});
  const auto plain_number = std::ranges::find_if(sum, [](const term& t) { return t.factors.empty(); });
  if (plain_number != sum.end()) std::rotate(plain_number, plain_number + 1, sum.end());
  const auto leader = std::ranges::find_if(sum, [](const term& t) { return !t.coefficient.negative(); });
  if (leader != sum.end()) std::rotate(sum.begin(), leader, leader + 1);
  return sum;
}

} // namespace kanexpr::symbolic::printing
