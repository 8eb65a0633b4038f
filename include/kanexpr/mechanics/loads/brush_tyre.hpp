#pragma once

#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

namespace kanexpr::mechanics {

/// The brush model of a tyre, Pacejka (2012), section 3.2, with the elastic force w = (C_x σ_x, C_y σ_y) at
/// the theoretical slip σ and θ = |w|/(3 μ F_z):
///
///     F = μ F_z (1 − m³) w/|w|,   M_z = −t w_y m³,   m = max(0, 1 − θ)
///
/// Here t is the pneumatic trail at small slip, a sixth of the length of the contact. F is the integral over
/// the contact of the smaller of the elastic force and the friction for a parabolic pressure; without F_x,
/// this is the tyre of Fiala. Instead of θ, θ²/√(θ² + η²) with η = 1e-4 is used, which is smooth at w = 0. F
/// has continuous second derivatives, also where the whole contact begins to slide, at θ = 1.
struct brush_tyre {
  symbolic::expression friction{};            ///< μ
  symbolic::expression slip_stiffness{};      ///< C_x
  symbolic::expression cornering_stiffness{}; ///< C_y
  symbolic::expression trail{};               ///< t
  symbolic::expression camber_stiffness{};    ///< C_γ: camber acts like the slip −C_γ sin γ/C_y

  constexpr tyre_effort at(const tyre_slip& s) const {
    using symbolic::expression, symbolic::real;
    const expression zero = s.load.number({}), one = s.load.number(symbolic::exactly(1));
    const expression width = zero.number(real(1e-4)), stiff = slip_stiffness + cornering_stiffness;
    // keeps w finite at no load, also in single precision, and changes nothing else by more than rounding
    const expression tiny = zero.number(real(1e-15)) * stiff + zero.number(real(1e-30));
    const expression limit = friction * s.load, least = 3 * limit, reach = least + tiny;
    const expression leaning = camber_stiffness * s.camber, bent = cornering_stiffness * s.lateral;
    const expression x = slip_stiffness * s.forward / reach, y = (bent - leaning) / reach;
    const expression theta = smooth_magnitude(symbolic::sum_of_products(x, x, y, y), width);
    const expression sticking = (symbolic::min)(theta, one), sliding = (symbolic::max)(theta, one);
    const expression square = sticking * sticking, share = 3 - 3 * sticking, adhesion = 1 - sticking;
    const expression factor = limit * (share + square) / sliding;
    const expression cube = adhesion * adhesion * adhesion, aligning = least * cube;
    return {factor * x, factor * y, zero, zero, -(trail * (aligning * y))};
  }
};

} // namespace kanexpr::mechanics
