#pragma once

#include <kanexpr/simulations/trajectory/dense_output.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace kanexpr::simulations {

KANEXPR_SIMULATIONS void piece::evaluate(double t, double* out, std::size_t entries) const {
  const std::size_t powers = coefficients.size() / entries;
  for (std::size_t i = 0; i < entries; ++i) {
    double sum = 0;
    for (std::size_t k = powers; k-- > 0;) sum = sum * (t - end) + coefficients[k * entries + i];
    out[i] = sum;
  }
}

KANEXPR_SIMULATIONS void dense_output::add(piece p) { pieces_.push_back(std::move(p)); }

KANEXPR_SIMULATIONS bool dense_output::evaluate(double t, double* out, std::size_t entries) const {
  const auto after = std::ranges::upper_bound(pieces_, t, {}, &piece::begin);
  if (after == pieces_.begin()) return false;
  const piece& p = *std::prev(after);
  if (t > p.end) return false;
  p.evaluate(t, out, entries);
  return true;
}

KANEXPR_SIMULATIONS void cubic(double part, double length, std::span<const double> a, const double* rates_a,
                               const double* b, const double* rates_b, double* out) {
  const double s = part, left = 1 - s;
  for (std::size_t i = 0; i < a.size(); ++i)
    out[i] = left * left * (1 + 2 * s) * a[i] + s * s * (3 - 2 * s) * b[i] +
             length * s * left * (left * rates_a[i] - s * rates_b[i]);
}

} // namespace kanexpr::simulations
