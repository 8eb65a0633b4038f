#pragma once

#include <kanexpr/simulations/compiled_simulations.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace kanexpr::simulations {

/// A polynomial in time for each entry of a state, over one step: Σ coefficients(k) (t − end)^k.
struct piece {
  double begin, end;
  std::vector<double> coefficients; ///< grouped by power

  void evaluate(double t, double* out, std::size_t entries) const;
};

/// The polynomials of all steps.
class dense_output {
public:
  void add(piece p);

  /// Evaluates the polynomial at a time, the later one where two meet; returns whether there is one.
  bool evaluate(double t, double* out, std::size_t entries) const;

private:
  std::vector<piece> pieces_{};
};

/// Evaluates the cubic Hermite interpolant of two states and their rates at a fraction of the interval
/// between them.
KANEXPR_SIMULATIONS void cubic(double part, double length, std::span<const double> a, const double* rates_a,
                               const double* b, const double* rates_b, double* out);

} // namespace kanexpr::simulations

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/trajectory/dense_output.ipp>
#endif
