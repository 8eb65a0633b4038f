#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kanexpr::simulated {

/// A polynomial in time for each entry of a state, over one step: Σ coefficients(k) (t − end)^k.
struct piece {
  double begin, end;
  std::vector<double> coefficients; ///< those of a power after one another

  void evaluate(double t, double* out, std::size_t entries) const {
    const std::size_t powers = coefficients.size() / entries;
    for (std::size_t i = 0; i < entries; ++i) {
      double sum = 0;
      for (std::size_t k = powers; k-- > 0;) sum = sum * (t - end) + coefficients[k * entries + i];
      out[i] = sum;
    }
  }
};

/// The polynomials of all steps.
class dense_output {
public:
  void add(piece p) { pieces_.push_back(std::move(p)); }

  /// Whether there is one for a time; the later one where two meet.
  bool evaluate(double t, double* out, std::size_t entries) const {
    const auto after = std::ranges::upper_bound(pieces_, t, {}, &piece::begin);
    if (after == pieces_.begin()) return false;
    const piece& p = *std::prev(after);
    if (t > p.end) return false;
    p.evaluate(t, out, entries);
    return true;
  }

private:
  std::vector<piece> pieces_{};
};

/// Hermite's cubic through two states with their rates, at a part of the way between them.
template <class State, class Rates>
State cubic(double part, double length, const State& a, const Rates& rates_a, const State& b,
            const Rates& rates_b) {
  const double s = part, left = 1 - s;
  return State(left * left * (1 + 2 * s) * a + s * s * (3 - 2 * s) * b +
               length * s * left * (left * rates_a - s * rates_b));
}

} // namespace kanexpr::simulated
