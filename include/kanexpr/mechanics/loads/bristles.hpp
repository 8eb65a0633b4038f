#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

/// The elastic bristles of the laws of friction by Dahl and LuGre, whose deflections are state variables.
namespace kanexpr::mechanics {

/// The friction force of bristles on the surface that slips, and the rates of their deflections, with one
/// entry for each direction.
struct moving_bristles {
  sequence<expression> force{};
  sequence<expression> rates{};
};

/// Bristles with the stiffness σ₀ and the damping σ₁, which deflect by z, for the normal force N, the slip
/// velocity v and the coefficient of friction μ:
///
///     z' = v − σ₀ |v| z/μ,   F = −N (σ₀ z + s σ₁ z')
///
/// C. Canudas de Wit, H. Olsson, K. J. Åström & P. Lischinsky (1995), doi 10.1109/9.376053; P. R. Dahl (1968)
/// without damping. In two or three directions, z and v are vectors.
///
/// - |v| is smooth: v²/√(v² + e²). It vanishes at rest, so that a load within the limits of friction is held
///   without creep.
/// - s = 1/(1 + σ₁ |v|/(4 μ)), which satisfies σ₁ s |v| ≤ 4 μ. With this condition, by N. Barabanov & R.
///   Ortega (2000), doi 10.1109/9.847119, the power −F v is not less than the rate of the energy N σ₀ z²/2,
///   so that the bristles create none.
/// - If N varies, the stored energy would vary with it. The state variable is then y = z √N with y' = √N v −
///   σ₀ |v| y/μ and F = −√N (σ₀ y + s σ₁ y'), which is the same for a constant N. The stored energy is σ₀
///   y²/2, so again none is created, whatever N and the motion are; there is no division by N, and F is zero
///   for N = 0.
struct bristles {
  expression stiffness{};             ///< σ₀, a force by N and the deflection
  expression damping{};               ///< σ₁, a force by N and the rate of the deflection; may be omitted
  expression stribeck_speed{};        ///< over which μ falls from its static value; not given for Dahl's law
  sequence<expression> deflections{}; ///< z or y

  /// Whether the state variables are the deflections themselves: whether N is constant.
  static constexpr bool are_deflections(expression normal_force) { return is_fixed(normal_force); }

  constexpr moving_bristles under(expression normal_force, const sequence<expression>& slip,
                                  expression slip_speed, expression coefficient) const {
    const bool is_constant = are_deflections(normal_force);
    const expression load = is_constant ? normal_force : root(normal_force);
    const expression size = smooth_size(slip, slip_speed) / coefficient;
    const expression relaxation = stiffness * size, passive = passive_damping(size);
    moving_bristles all;
    for (int i = 0; i < slip.size(); ++i) {
      const expression drawn = is_constant ? slip[i] : load * slip[i], relaxed = relaxation * deflections[i];
      const expression rate = drawn - relaxed, elastic = stiffness * deflections[i];
      all.rates.push(rate);
      all.force.push(-(load * (elastic + passive * rate)));
    }
    return all;
  }

private:
  constexpr expression smooth_size(const sequence<expression>& slip, expression slip_speed) const {
    expression squared = slip[0] * slip[0];
    for (int i = 1; i < slip.size(); ++i) squared += slip[i] * slip[i];
    return squared / sqrt(squared + slip_speed * slip_speed);
  }

  /// s σ₁; `size` is |v|/μ.
  constexpr expression passive_damping(expression size) const {
    if (!damping.is_given() || damping.is_zero()) return size.number(symbolic::exactly(0));
    const expression excess = damping * size / 4;
    return damping / (1 + excess);
  }

  /// √|N| with the sign of N. A force of 1e-15 keeps its derivatives finite at N = 0; it changes the result
  /// by less than rounding for N above 1e-7.
  static constexpr expression root(expression normal_force) {
    const expression tiny = normal_force.number(symbolic::real(1e-30));
    return normal_force / sqrt(sqrt(normal_force * normal_force + tiny));
  }
};

} // namespace kanexpr::mechanics
