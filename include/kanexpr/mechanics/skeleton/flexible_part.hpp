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
  /// One amplitude q_k; the sequences have an entry for each amplitude q_l.
  struct amplitude {
    expression rate{}; ///< q̇_k as an expression of q, u and t
    sequence<rate_partial> partials{};
    components translation{};                ///< P_k = ∂S/∂q_k
    components rotation{};                   ///< H_k
    symmetric growth{};                      ///< ∂J/∂q_k
    sequence<components> translation_rate{}; ///< ∂P_k/∂q_l
    sequence<components> rotation_rate{};    ///< ∂H_k/∂q_l
  };

  int station = none;
  int frame = none;    ///< the representative of the frame relative to which the body deforms
  int axes = none;     ///< that frame
  components offset{}; ///< the reference point of the model, measured from the station
  rigid_mass mass{};   ///< m, S and J, which depend on the amplitudes
  sequence<amplitude> amplitudes{};
  symbolic::matrix modal_mass{};
};

} // namespace kanexpr::mechanics
