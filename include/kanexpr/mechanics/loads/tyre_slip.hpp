#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

namespace kanexpr::mechanics {

/// The quantities on which the forces of a tyre depend, in the axes of ISO 8855: x is forward, y is to the
/// left, z is the normal of the ground and points up.
///
/// A slip is minus the slip velocity divided by a speed, so it has the sign of the force. With the speed |Vₓ|
/// of the contact, it is κ and −tan α, the practical slip; with the speed |Vₓ − V_sx| at which the tread
/// passes, it is the theoretical slip of the brush model. Pacejka (2012), sections 2.2 and 3.3.
struct tyre_slip {
  symbolic::expression load{};      ///< F_z
  symbolic::expression forward{};   ///< −V_sx divided by the speed
  symbolic::expression lateral{};   ///< −V_sy divided by the speed
  symbolic::expression camber{};    ///< sin γ; positive if the top of the wheel leans to the right
  symbolic::expression velocity{};  ///< V_x
  symbolic::expression direction{}; ///< the sign of V_x, smooth about standstill
};

/// The forces and moments of the ground on a tyre at the contact, in the same axes.
struct tyre_effort {
  symbolic::expression forward{};     ///< F_x
  symbolic::expression lateral{};     ///< F_y
  symbolic::expression overturning{}; ///< M_x
  symbolic::expression rolling{};     ///< M_y
  symbolic::expression aligning{};    ///< M_z
};

/// √(v² + v₀²), a speed that is smooth at v = 0 and never zero.
constexpr symbolic::expression speed_above(symbolic::expression v, symbolic::expression least) {
  return sqrt(symbolic::sum_of_products(v, v, least, least));
}

/// v²/√(v² + v₀²), which is |v| for large v, smooth at v = 0 and zero there.
constexpr symbolic::expression smooth_magnitude(symbolic::expression squared, symbolic::expression width) {
  const symbolic::expression floor = width * width;
  return squared / sqrt(squared + floor);
}

} // namespace kanexpr::mechanics
