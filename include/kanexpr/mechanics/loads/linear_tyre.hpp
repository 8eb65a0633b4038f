#pragma once

#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A tyre whose forces are linear in its slips: F_x = C_κ κ, F_y = −C_α tan α − C_γ sin γ, and the aligning
/// moment M_z = t C_α tan α with the pneumatic trail t.
struct linear_tyre {
  symbolic::expression slip_stiffness{};      ///< C_κ
  symbolic::expression cornering_stiffness{}; ///< C_α
  symbolic::expression camber_stiffness{};    ///< C_γ
  symbolic::expression trail{};               ///< t

  constexpr tyre_effort at(const tyre_slip& s) const {
    const symbolic::expression cornering = cornering_stiffness * s.lateral;
    const symbolic::expression leaning = camber_stiffness * s.camber, zero = s.camber.number({});
    return {slip_stiffness * s.forward, cornering - leaning, zero, zero, -(trail * cornering)};
  }
};

} // namespace kanexpr::mechanics
