#pragma once

#include <kanexpr/simulate/compiled_simulations.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace kanexpr::simulated {

/// A polynomial in time for each entry of a state, over one step: Σ coefficients(k) (t − end)^k.
struct piece {
  double begin, end;
  std::vector<double> coefficients; ///< those of a power after one another

  void evaluate(double t, double* out, std::size_t entries) const;
};

/// The polynomials of all steps.
class dense_output {
public:
  void add(piece p);

  /// Whether there is one for a time; the later one where two meet.
  bool evaluate(double t, double* out, std::size_t entries) const;

private:
  std::vector<piece> pieces_{};
};

/// Hermite's cubic through two states with their rates, at a part of the way between them.
KANEXPR_SIMULATIONS void cubic(double part, double length, std::span<const double> a, const double* rates_a,
                               const double* b, const double* rates_b, double* out);

} // namespace kanexpr::simulated

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulate/engine/dense_output.hpp>
#endif
