#pragma once

#include <kanexpr/symbolic/limits/series.hpp>

#include <utility>

namespace kanexpr::symbolic::taylor {

/// Why an operation has no series.
enum class obstacle {
  none,
  truncated,         ///< with more terms it may have
  zero_divisor,      ///< zero along the whole line
  zero_logarithm,    ///< the logarithm of what vanishes
  infinite_argument, ///< of an exponential or a sine
  not_real,
  fractional_order, ///< powers of ε between the integers
  singular_system,  ///< along the whole line
  piecewise,        ///< the first term vanishes for some values of the symbols that stay
};

/// A series, or why there is none.
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

} // namespace kanexpr::symbolic::taylor
