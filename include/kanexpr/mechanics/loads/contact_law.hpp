#pragma once

#include <kanexpr/mechanics/loads/one_sided.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstdint>

namespace kanexpr::mechanics {

/// The exponent of a contact as an exact number if it is a multiple of 1/2, because powers of such exponents
/// are products and square roots; an expression without a graph if it is not a number from 1 to 30.
constexpr expression contact_exponent(expression n) {
  if (!n.is_constant()) return {};
  const double value = n.owner().number_at(n.node()).value();
  if (!(value >= 1 && value <= 30)) return {};
  const auto twice = static_cast<std::int64_t>(2 * value);
  const bool is_half = static_cast<double>(twice) >= 2 * value;
  return is_half ? n.number(symbolic::exactly(twice, 2)) : n;
}

/// The normal force of a contact: N = k sⁿ s'(δ) h(c δ̇), where δ is the penetration.
///
/// s(δ) is max(δ, 0) rounded between −w and w: 0 below and δ above, with continuous second derivatives. The
/// elastic part k sⁿ s' is the derivative of the potential energy k sⁿ⁺¹/(n + 1) and vanishes for δ ≤ −w. The
/// factor h is 1 + c δ̇, as by Hunt & Crossley (1975), doi 10.1115/1.3423596, but rounded where that is within
/// 1/4 of zero and never negative. Since h increases and is exactly 1 at δ̇ = 0, the contact never pulls, and
/// its inelastic part only takes energy, whatever the motion is.
struct contact_law {
  expression stiffness{}; ///< k
  expression exponent{};  ///< n, a number of at least 1
  expression width{};     ///< w
  expression damping{};   ///< c; not given if the contact is elastic

  constexpr expression elastic_force(expression penetration) const {
    const expression x = penetration + width, across = 2 * width;
    const expression zero = x.number(symbolic::exactly(0)), one = x.number(symbolic::exactly(1));
    const expression t = symbolic::clamp(x / across, zero, one), slope = t * t * (3 - 2 * t);
    return stiffness * power(rounded(penetration) + tiny(), exponent) * slope;
  }

  constexpr expression energy(expression penetration) const {
    const expression above = exponent + 1, all = power(rounded(penetration) + tiny(), above);
    return stiffness * (all - power(tiny(), above)) / above;
  }

  /// h(c δ̇)
  constexpr expression dissipation(expression rate) const {
    if (!damping.is_given() || damping.is_zero()) return rate.number(symbolic::exactly(1));
    return dissipation_factor(damping, rate);
  }

private:
  constexpr expression rounded(expression penetration) const {
    const expression across = 2 * width;
    return one_sided(penetration + width, across);
  }
  /// A length that keeps all derivatives of powers finite at s = 0; it changes the force by less than
  /// rounding.
  constexpr expression tiny() const { return width.number(symbolic::real(1e-15)) * width; }
};

} // namespace kanexpr::mechanics
