#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::limits {

/// Solves A x = b by elimination with row exchanges, for a square A stored by rows and x holding b on entry;
/// returns false if a column has no pivot. Overwrites both.
///
/// `worth(x)` rates a pivot: an optional of any comparable type, empty if x cannot be a divisor.
template <class Number, class Worth>
bool eliminate(std::vector<Number>& a, std::vector<Number>& x, Worth worth) {
  const std::size_t order = x.size();
  const auto at = [&](std::size_t i, std::size_t j) -> Number& { return a[i * order + j]; };
  for (std::size_t k = 0; k < order; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < order; ++i)
      if (worth(at(i, k)) > worth(at(pivot, k))) pivot = i;
    if (!worth(at(pivot, k))) return false;
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

} // namespace kanexpr::symbolic::limits
