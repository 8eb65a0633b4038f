#pragma once

#include <kanexpr/symbolic/limits/series.hpp>

#include <utility>

namespace kanexpr::symbolic::limits {

/// The reason why an operation has no series.
enum class obstacle {
  none,
  truncated,         ///< more terms may help
  zero_divisor,      ///< zero along the whole line
  zero_logarithm,    ///< the argument of a logarithm is zero
  infinite_argument, ///< the argument of an exponential or a sine
  not_real,
  fractional_order, ///< non-integer powers of ε
  singular_system,  ///< along the whole line
  piecewise,        ///< the leading term vanishes for some values of the remaining symbols
};

/// A series, or the reason why there is none.
class expansion {
public:
  expansion(series found) : found_(std::move(found)) {}
  expansion(obstacle met) : met_(met) {}

  explicit operator bool() const { return met_ == obstacle::none; }
  const series& operator*() const { return found_; }
  const series* operator->() const { return &found_; }
  obstacle met() const { return met_; }

private:
  series found_{};
  obstacle met_ = obstacle::none;
};

inline expansion quotient(const series& a, const series& b) {
  if (b.is_zero()) return obstacle::zero_divisor;
  if (!b.has_terms()) return obstacle::truncated;
  return a / b;
}

} // namespace kanexpr::symbolic::limits
