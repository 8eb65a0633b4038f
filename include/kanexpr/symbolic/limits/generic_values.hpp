#pragma once

#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/limits/bounded.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::limits {

/// The values of an expression at generic values of its symbols; an expression that vanishes at these values
/// is assumed to vanish everywhere. A number has only one value.
class generic_values {
public:
  static constexpr int count = 4;

  generic_values() = default;
  explicit generic_values(const bounded& number) { at_[0] = number; }
  template <class At>
  static generic_values by(bool is_number, At at) {
    generic_values all;
    all.is_number_ = is_number;
    for (int i = 0; i < all.size(); ++i) all.at_[static_cast<std::size_t>(i)] = at(i);
    return all;
  }
  /// The generic values of a symbol: small and large, because some functions are not defined everywhere.
  /// Parameters are positive, as masses and lengths are.
  static generic_values of_symbol(symbol_kind kind, int place) {
    std::uint64_t random = 88172645463325252u + static_cast<std::uint64_t>(place) * 0x9e3779b97f4a7c15u;
    constexpr double scales[count] = {1, 0.3, 3, 20};
    return by(false, [&](int i) {
      for (int twice = 0; twice < 2; ++twice) // Marsaglia's xorshift
        random ^= random << 13, random ^= random >> 7, random ^= random << 17;
      const double between = static_cast<double>(random >> 11) / 9007199254740992.0;
      return bounded{scales[i] * (kind == symbol_kind::parameter ? 0.5 + between : 1.8 * between - 0.9), 0};
    });
  }

  const bounded& operator[](int i) const { return at_[is_number_ ? 0 : static_cast<std::size_t>(i)]; }
  bool is_number() const { return is_number_; }
  int size() const { return is_number_ ? 1 : count; }

  bool defined() const { return std::ranges::any_of(values(), &bounded::defined); }
  /// Whether the expression vanishes wherever it is defined.
  bool vanishes_everywhere() const {
    const auto differs = [](const bounded& v) { return v.defined() && !v.vanishes(); };
    return defined() && std::ranges::none_of(values(), differs);
  }
  /// Whether the expression vanishes at some values of the symbols but not at others, like abs(x) - x.
  bool vanishes_at_some() const {
    const auto vanishes = [](const bounded& v) { return v.defined() && v.vanishes(); };
    return !vanishes_everywhere() && std::ranges::any_of(values(), vanishes);
  }

private:
  std::span<const bounded> values() const { return {at_.data(), static_cast<std::size_t>(size())}; }

  std::array<bounded, count> at_{};
  bool is_number_ = true;
};

inline generic_values apply(operation op, const generic_values& a, const generic_values& b) {
  return generic_values::by(a.is_number() && b.is_number(), [&](int i) { return apply(op, a[i], b[i]); });
}

/// Whether an operation is undefined wherever its operands are defined.
inline bool is_singular(operation op, const generic_values& a, const generic_values& b) {
  bool is_known = false;
  for (int i = 0; i < (a.is_number() ? b : a).size(); ++i) {
    if (!a[i].defined() || !b[i].defined()) continue;
    if (!is_singular(op, a[i], b[i])) return false;
    is_known = true;
  }
  return is_known;
}

/// Whether a selection never passes its second operand.
inline bool never_selects(operation op, const generic_values& condition) {
  for (int i = 0; i < condition.size(); ++i)
    if (!condition[i].defined() || is_singular(op, condition[i], {}) ||
        !base::equal(selected(op, condition[i].value, 1), 0.0))
      return false;
  return true;
}

/// Solves A x = b by elimination with row exchanges, for a square A stored by rows and x holding b on entry;
/// returns false if a column has no pivot. Overwrites both.
///
/// `rank_pivot(x)` returns an optional of any comparable type: the largest value for the best pivot, and
/// nothing if x cannot be a divisor.
template <class Number, class Worth>
bool eliminate(std::vector<Number>& a, std::vector<Number>& x, Worth rank_pivot) {
  const std::size_t order = x.size();
  const auto at = [&](std::size_t i, std::size_t j) -> Number& { return a[i * order + j]; };
  for (std::size_t k = 0; k < order; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < order; ++i)
      if (rank_pivot(at(i, k)) > rank_pivot(at(pivot, k))) pivot = i;
    if (!rank_pivot(at(pivot, k))) return false;
    for (std::size_t j = k; j < order && pivot != k; ++j) std::swap(at(k, j), at(pivot, j));
    if (pivot != k) std::swap(x[k], x[pivot]);
    for (std::size_t i = k + 1; i < order; ++i) {
      const Number multiplier = at(i, k) / at(k, k);
      for (std::size_t j = k + 1; j < order; ++j) at(i, j) = at(i, j) - multiplier * at(k, j);
      x[i] = x[i] - multiplier * x[k];
    }
  }
  for (std::size_t k = order; k-- > 0;) {
    for (std::size_t j = k + 1; j < order; ++j) x[k] = x[k] - at(k, j) * x[j];
    x[k] = x[k] / at(k, k);
  }
  return true;
}

/// Solves A x = b with A stored by rows; returns nothing if the matrix is singular wherever it is defined.
inline std::optional<std::vector<generic_values>> solved(const std::vector<generic_values>& a,
                                                         const std::vector<generic_values>& b) {
  bool is_number = true, is_defined = false, is_regular = false;
  for (const auto* list : {&a, &b})
    for (const generic_values& v : *list) is_number = is_number && v.is_number();
  std::array<std::vector<bounded>, generic_values::count> x;
  for (int s = 0; s < (is_number ? 1 : generic_values::count); ++s) {
    std::vector<bounded> entries, &right = x[static_cast<std::size_t>(s)];
    bool all = true;
    for (const generic_values& v : a) entries.push_back(v[s]), all = all && v[s].defined();
    for (const generic_values& v : b) right.push_back(v[s]), all = all && v[s].defined();
    const auto rank_pivot = [](const bounded& v) {
      return v.defined() && !v.vanishes() ? std::optional(std::abs(v.value)) : std::nullopt;
    };
    const bool found = all && eliminate(entries, right, rank_pivot);
    if (!found) right.assign(b.size(), bounded::undefined());
    is_defined = is_defined || all;
    is_regular = is_regular || found;
  }
  if (is_defined && !is_regular) return std::nullopt;
  std::vector<generic_values> solution;
  solution.reserve(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    solution.push_back(
        generic_values::by(is_number, [&](int s) { return x[static_cast<std::size_t>(s)][i]; }));
  return solution;
}

} // namespace kanexpr::symbolic::limits
