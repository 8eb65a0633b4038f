#pragma once

#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/numbers/nearby_fraction.hpp>

namespace kanexpr::mechanics {

/// Linear and quadratic forms in the amplitudes of a beam, whose coefficients are numbers.
class beam_forms {
  // clang requires that templates used by constant expressions be defined before the functions that use them
protected:
  constexpr explicit beam_forms(const beam& of)
      : b_(of), g_(of.length.owner()), mass_(of.mass_per_length * of.length) {}

  constexpr int size() const { return b_.amplitudes.size(); }
  static constexpr bool is_zero(double value) { return value * value <= 0; }

  /// A number times an expression.
  constexpr expression times(double number, expression e) const {
    if (is_zero(number)) return zero();
    return symbolic::constant(g_, symbolic::nearby_fraction(number)) * e;
  }
  constexpr expression zero() const { return {g_, symbolic::graph::zero}; }

  /// Σ c_k q_k over the amplitudes of one deformation, with numbers c_k.
  template <class Number>
  constexpr expression linear(deformation what, Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      if (b_.deformations[k] == what) sum += times(c(k), b_.amplitudes[k]);
    return sum;
  }
  /// Σ c_kl q_k q_l over the amplitudes of two deformations.
  template <class Number>
  constexpr expression bilinear(deformation one, deformation other, Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l < size(); ++l)
        if (b_.deformations[k] == one && b_.deformations[l] == other)
          sum += times(c(k, l), b_.amplitudes[k] * b_.amplitudes[l]);
    return sum;
  }
  /// Σ c_kl q_k q_l over pairs of amplitudes of the same deformation, with a symmetric c.
  template <class Number>
  constexpr expression quadratic(Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l <= k; ++l)
        if (b_.deformations[k] == b_.deformations[l])
          sum += times(k == l ? c(k, k) : 2 * c(k, l), b_.amplitudes[l] * b_.amplitudes[k]);
    return sum;
  }

  /// The direction in which shape k displaces the axis; torsion does not displace it.
  constexpr const components& direction(int k) const {
    switch (b_.deformations[k]) {
    case deformation::first_bending: return b_.across[0];
    case deformation::second_bending: return b_.across[1];
    case deformation::torsion:
    case deformation::extension: break;
    }
    return b_.axis;
  }

  const beam& b_;
  symbolic::graph& g_;
  expression mass_{}; ///< of the beam, if its profile is 1
};

} // namespace kanexpr::mechanics
