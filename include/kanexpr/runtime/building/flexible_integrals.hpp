#pragma once

#include <kanexpr/runtime/building/number_or_expression.hpp>

#include <array>
#include <vector>

namespace kanexpr::runtime {

/// The index of a flexible body that a builder has formed from numbers.
enum class flexible_body_id : int {};

/// The data of a flexible body with the amplitudes q_1 … q_n, as numbers or as expressions of the amplitudes
/// and parameters. A particle of the body is at r(q) from the reference point; its place, and all components,
/// are measured in the frame relative to which the body deforms. The integrals extend over the mass of the
/// body. To be consistent to the second order in the amplitudes and their rates, the first moment and the
/// inertia must be given to the second order, and the angular integrals to the first.
struct flexible_integrals {
  using vector_entries = std::array<number_or_expression, 3>;
  using matrix = std::vector<std::vector<number_or_expression>>;

  number_or_expression mass;
  vector_entries first_moment{0.0, 0.0, 0.0}; ///< ∫ r dm
  /// ∫ (r·r E − r r) dm about the reference point: xx, yy, zz, xy, yz, zx.
  std::array<number_or_expression, 6> inertia{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  std::vector<vector_entries> angular{}; ///< ∫ r × ∂r/∂q_k dm for each amplitude; empty: zero
  matrix modal_mass{};                   ///< ∫ ∂r/∂q_k · ∂r/∂q_l dm, constant
  matrix stiffness{};                    ///< K in the elastic energy ½ q·K·q; empty: none
  matrix damping{};                      ///< D in the generalized forces −D q̇; empty: none
};

} // namespace kanexpr::runtime
