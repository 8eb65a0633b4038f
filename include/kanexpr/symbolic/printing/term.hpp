#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/named_parts.hpp>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

/// Expressions as flat sums of flat products, as they are written by hand. All printed forms start from
/// these.
namespace kanexpr::symbolic::printing {

struct factor {
  int base = 0;
  std::int64_t exponent = 1;

  auto operator<=>(const factor&) const = default;
};

/// coefficient · Π base^exponent, with the factors in printing order.
struct term {
  number coefficient = exactly(1);
  std::vector<factor> factors{};
};

/// The numerator or denominator of a term, with positive numbers and exponents only.
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

/// Whether an operation is printed as a function name with arguments, or as a list among such arguments.
inline bool is_written_as_function(operation op) {
  return *function_name(op) != '\0' || op >= operation::pair;
}

/// Decomposes a node into weighted parts as `expand` specifies. Nodes follow their operands, so each node is
/// visited once, with its total weight. Returns the parts that cannot be decomposed, by node.
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

inline number integer_power(const number& base, std::int64_t exponent) {
  return power_by_squaring(exponent < 0 ? exactly(1) / base : base,
                           static_cast<std::uint64_t>(std::abs(exponent)), exactly(1), std::multiplies<>());
}

/// Compares names so that q2 precedes q10.
inline std::strong_ordering compare_names(std::string_view a, std::string_view b) {
  const auto letters = [](std::string_view text) { return text.find_last_not_of("0123456789") + 1; };
  const std::size_t i = letters(a), j = letters(b);
  if (const auto order = a.substr(0, i) <=> b.substr(0, j); order != 0) return order;
  if (a.size() != b.size()) return a.size() <=> b.size();
  return a <=> b;
}

/// Reads a graph as sums of products. The order of terms and factors depends only on names and structure,
/// because node numbers depend on the order in which a user's compiler evaluates operands.
class term_reader {
public:
  /// Parts with names are factors of their own wherever they occur.
  explicit term_reader(const graph& g, const named_parts* parts = nullptr) : graph_(g), parts_(parts) {}
  term_reader(const term_reader&) = delete;
  term_reader& operator=(const term_reader&) = delete;

  /// A node as a nonempty sum; numbers come last, except that a positive term comes first if there is one.
  const std::vector<term>& terms_of(int id) {
    if (!is_part(id)) return definition_of(id);
    return references_.try_emplace(id, 1, term{exactly(1), {{id, 1}}}).first->second;
  }

  /// The same of a part, without its own name.
  const std::vector<term>& definition_of(int id) {
    const auto known = sums_.find(id);
    return known != sums_.end() ? known->second : sums_.emplace(id, sum_of(id)).first->second;
  }

  bool is_part(int id) const { return parts_ != nullptr && parts_->has(id); }

private:
  /// `defined` is the part whose definition the product belongs to.
  term product_of(int root, int defined) {
    constexpr std::int64_t largest_exponent = std::int64_t{1} << 30;
    term product;
    const auto expand = [&](int id, std::int64_t exponent, const auto& put) {
      if (exponent > largest_exponent || exponent < -largest_exponent) return false;
      if (id != defined && is_part(id)) return false;
      const node& n = graph_[id];
      if (n.op == operation::constant) {
        if (id == graph::zero && exponent < 0) return false;
        product.coefficient = product.coefficient * integer_power(graph_.number_at(id), exponent);
        return true;
      }
      if (n.op == operation::negate) {
        if (exponent % 2 != 0) product.coefficient = -product.coefficient;
        put(n.a, exponent);
        return true;
      }
      if (n.op != operation::multiply && n.op != operation::divide) return false;
      put(n.a, exponent);
      put(n.b, n.op == operation::multiply ? exponent : -exponent);
      return true;
    };
    for (const auto& [base, exponent] : gather(root, std::int64_t{1}, expand))
      if (exponent != 0) product.factors.push_back({base, exponent});
    std::ranges::sort(product.factors,
                      [this](const factor& a, const factor& b) { return compare_factors(a, b) < 0; });
    return product;
  }

  std::vector<term> sum_of(int root) {
    const auto expand = [this, root](int id, const number& weight, const auto& put) {
      const node& n = graph_[id];
      if (id != root && is_part(id)) return false;
      if (n.op != operation::add && n.op != operation::subtract && n.op != operation::negate) return false;
      put(n.a, n.op == operation::negate ? -weight : weight);
      if (is_binary(n.op)) put(n.b, n.op == operation::subtract ? -weight : weight);
      return true;
    };
    std::map<std::vector<factor>, number> gathered;
    for (const auto& [id, weight] : gather(root, exactly(1), expand)) {
      const term t = product_of(id, root);
      number& coefficient = gathered.try_emplace(t.factors, exactly(0)).first->second;
      coefficient = coefficient + t.coefficient * weight;
    }
    std::vector<term> sum;
    for (const auto& [factors, coefficient] : gathered)
      if (coefficient != exactly(0)) sum.push_back({coefficient, factors});
    if (sum.empty()) sum.push_back({exactly(0), {}});
    std::ranges::sort(sum, [this](const term& a, const term& b) { return compare_terms(a, b) < 0; });
    const auto leader = std::ranges::find_if(sum, [](const term& t) { return !t.coefficient.negative(); });
    if (leader != sum.end()) std::rotate(sum.begin(), leader, leader + 1);
    return sum;
  }

  /// The printing order of factors: parameters, other symbols, general powers, functions, and finally factors
  /// that need parentheses.
  int rank(int id) const {
    const operation op = graph_[id].op;
    if (op == operation::symbol) return graph_.symbol_at(id).kind == symbol_kind::parameter ? 0 : 1;
    return op == operation::power ? 2 : is_written_as_function(op) ? 3 : 4;
  }

  std::strong_ordering compare(int a, int b) {
    if (a == b) return std::strong_ordering::equal;
    const auto known = compared_.find({a, b});
    if (known != compared_.end()) return known->second;
    return compared_.emplace(std::pair(a, b), compare_structure(a, b)).first->second;
  }

  std::strong_ordering compare_structure(int a, int b) {
    const node &x = graph_[a], &y = graph_[b];
    if (const auto order = rank(a) <=> rank(b); order != 0) return order;
    if (x.op == operation::symbol) {
      const symbol &s = graph_.symbol_at(a), &t = graph_.symbol_at(b);
      const auto order = compare_names(s.called.view(), t.called.view());
      return order != 0 ? order : s.kind <=> t.kind;
    }
    if (rank(a) == 4) return compare_all(definition_of(a), definition_of(b), &term_reader::compare_terms);
    if (x.op != y.op) return x.op <=> y.op;
    if (x.op == operation::call) {
      const auto names =
          compare_names(graph_.external_at(a).called.view(), graph_.external_at(b).called.view());
      return names != 0 ? names : compare(x.a, y.a);
    }
    const auto order = compare(x.a, y.a);
    return order != 0 || !is_binary(x.op) ? order : compare(x.b, y.b);
  }

  std::strong_ordering compare_terms(const term& a, const term& b) {
    if (a.factors.empty() != b.factors.empty()) return a.factors.empty() <=> b.factors.empty();
    const auto order = compare_all(a.factors, b.factors, &term_reader::compare_factors);
    return order != 0 ? order : std::strong_order(a.coefficient.value(), b.coefficient.value());
  }

  std::strong_ordering compare_factors(const factor& a, const factor& b) {
    const auto order = compare(a.base, b.base);
    return order != 0 ? order : b.exponent <=> a.exponent;
  }

  template <class Part>
  std::strong_ordering compare_all(const std::vector<Part>& a, const std::vector<Part>& b,
                                   std::strong_ordering (term_reader::*order)(const Part&, const Part&)) {
    for (std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
      if (const auto found = (this->*order)(a[i], b[i]); found != 0) return found;
    return a.size() <=> b.size();
  }

  const graph& graph_;
  const named_parts* parts_;
  std::map<int, std::vector<term>> sums_{}, references_{};
  std::map<std::pair<int, int>, std::strong_ordering> compared_{};
};

} // namespace kanexpr::symbolic::printing
