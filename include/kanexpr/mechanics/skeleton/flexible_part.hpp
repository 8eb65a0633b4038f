#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

namespace kanexpr::mechanics {

/// A flexible body prepared for the dynamics: its integrals, their derivatives with respect to the amplitudes
/// q_k, and the rates of the amplitudes. All components are in the axes of the frame relative to which the
/// body deforms. The integrals refer to a station fixed in this frame, which need not be the reference point
/// of the model.
struct flexible_part {
  /// The derivative of an amplitude's rate with respect to one generalized speed.
  struct rate_partial {
    int speed = none;
    expression value{};
  };
  /// One amplitude q_k; the sequences have an entry for each amplitude q_l. The derivatives are partial ones,
  /// for constant displacements.
  struct amplitude {
    expression rate{}; ///< q̇_k as an expression of q, u and t
    sequence<rate_partial> partials{};
    components translation{};                ///< P_k = ∂S/∂q_k
    components rotation{};                   ///< H_k
    symmetric growth{};                      ///< ∂J/∂q_k
    sequence<components> translation_rate{}; ///< ∂P_k/∂q_l
    sequence<components> rotation_rate{};    ///< ∂H_k/∂q_l
  };

  /// A displacement y(q); the sequences have an entry for each amplitude q_k. If the kinetic energy contains
  /// its rate, the displacement has a mass.
  struct displacement {
    sequence<expression> gradient{};              ///< ∂y/∂q_k
    expression rate{};                            ///< ẏ
    expression bias{};                            ///< Σ ∂²y/∂q_k∂q_l q̇_k q̇_l
    components translation{};                     ///< P_y = ∂S/∂y
    components rotation{};                        ///< H_y
    symmetric growth{};                           ///< ∂J/∂y
    sequence<components> rotation_by_amplitude{}; ///< ∂H_y/∂q_k
    sequence<components> rotation_rate{};         ///< ∂H_k/∂y
    expression mass{};                            ///< M_yy
    sequence<expression> coupling{};              ///< M_ky
  };

  int station = none;
  int frame = none;    ///< the representative of the frame relative to which the body deforms
  int axes = none;     ///< that frame
  components offset{}; ///< the reference point of the model, measured from the station
  rigid_mass mass{};   ///< m, S and J, which depend on the amplitudes
  sequence<amplitude> amplitudes{};
  symbolic::matrix modal_mass{}; ///< M_kl, constant
  sequence<displacement> displacements{};

  /// dS/dq_k, with the displacements.
  constexpr components total_translation(int k) const {
    components sum = amplitudes[k].translation;
    for (const displacement& y : displacements) sum += y.gradient[k] * y.translation;
    return sum;
  }
  /// The angular momentum about the station per unit of q̇_k, with the rates of the displacements.
  constexpr components total_rotation(int k) const {
    components sum = amplitudes[k].rotation;
    for (const displacement& y : displacements) sum += y.gradient[k] * y.rotation;
    return sum;
  }
  /// M_kl + Σ (M_ky ∂y/∂q_l + M_ly ∂y/∂q_k + M_yy ∂y/∂q_k ∂y/∂q_l).
  constexpr expression total_modal_mass(int k, int l) const {
    expression sum = modal_mass(k, l);
    for (const displacement& y : displacements) {
      sum += (y.mass * y.gradient[k]) * y.gradient[l];
      sum += y.coupling[k] * y.gradient[l];
      sum += y.coupling[l] * y.gradient[k];
    }
    return sum;
  }
};

} // namespace kanexpr::mechanics
