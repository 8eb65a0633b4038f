#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

namespace kanexpr::symbolic {

using base::sequence;

/// Inverts a matrix of numbers stored in row-major order, exactly if they are fractions. Returns an empty
/// sequence if the matrix is singular.
constexpr sequence<number> inverse_of(sequence<number> a, int order) {
  sequence<number> inverse(order * order, exactly(0));
  for (int i = 0; i < order; ++i) inverse[i * order + i] = exactly(1);
  const auto magnitude = [](const number& n) { return n.negative() ? -n.value() : n.value(); };
  const auto subtract_row = [&](sequence<number>& m, int from, int row, const number& weight) {
    for (int j = 0; j < order; ++j) m[from * order + j] = m[from * order + j] - weight * m[row * order + j];
  };
  for (int k = 0; k < order; ++k) {
    int pivot = k;
    for (int i = k + 1; i < order; ++i)
      if (magnitude(a[i * order + k]) > magnitude(a[pivot * order + k])) pivot = i;
    if (base::equal(magnitude(a[pivot * order + k]), 0.0)) return {};
    const number below = a[pivot * order + k];
    for (sequence<number>* m : {&a, &inverse})
      for (int j = 0; j < order; ++j) {
        const number lifted = (*m)[pivot * order + j] / below;
        (*m)[pivot * order + j] = (*m)[k * order + j];
        (*m)[k * order + j] = lifted;
      }
    for (int i = 0; i < order; ++i) {
      const number weight = a[i * order + k];
      if (i == k || base::equal(magnitude(weight), 0.0)) continue;
      subtract_row(a, i, k, weight);
      subtract_row(inverse, i, k, weight);
    }
  }
  return inverse;
}

} // namespace kanexpr::symbolic
