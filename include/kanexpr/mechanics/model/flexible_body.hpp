#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/beam_outline.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

namespace kanexpr::mechanics {

/// The nodes of a flexible body at which figures and pictures show it. Only models that are derived at run
/// time have them.
struct nodes_for_pictures {
  base::sequence<flexible_node> all{};

  /// A stage of a derivation at compile time does not store them.
  template <class Self, class Visit>
  static constexpr void each_member(Self&, Visit&&) {}
};

/// A displacement y(q) ψ(x) along the axis of a beam. Its contributions to the integrals of `flexible_body`
/// are linear in y, apart from y² in the inertia.
struct axial_displacement {
  symbolic::expression value{};                    ///< y
  components first_moment{};                       ///< the coefficient of y
  symmetric inertia{};                             ///< the coefficient of y, linear in the amplitudes
  symmetric squared{};                             ///< the coefficient of y² in the inertia, constant
  base::sequence<components> angular{};            ///< by amplitude: the coefficient of y, constant
  base::sequence<symbolic::expression> coupling{}; ///< by amplitude: ∫ ψ a · ∂r/∂q_k dm
};

/// The integrals of a kinetic energy that is a sum of squares, and therefore positive for every motion and
/// all amplitudes; without the contributions of the displacements. They equal those of `flexible_body` to
/// their order. The first displacement about the center moves the whole body; its rate multiplies the
/// velocity along the axis.
struct definite_inertia {
  components first_moment{};
  symmetric inertia{};
  base::sequence<components> angular{};
  components axis{};
  base::sequence<axial_displacement> about_center{};
  base::sequence<axial_displacement> about_root{}; ///< if the reference point is at rest; with the first
                                                   ///< moment of `flexible_body`

  constexpr bool is_given() const { return !angular.empty(); }
};

/// A body that deforms relative to a frame (floating frame of reference). A particle of the body is at
/// r(x, q) from the reference point, where x is its place in the undeformed body and q are the amplitudes of
/// the shapes. The body enters the equations only through the integrals below over its mass; they are
/// expressions of the amplitudes in the axes of the frame, correct to the second order of its kinetic energy
/// in the amplitudes and their rates. Definitions: Wallrapp (1994), Standardization of flexible body modeling
/// in multibody system codes.
struct flexible_body {
  base::name called{};
  int frame = -1;                                    ///< the frame relative to which the body deforms
  int reference = -1;                                ///< the point from which r is measured, fixed in `frame`
  base::sequence<symbolic::expression> amplitudes{}; ///< the coordinates q_k
  symbolic::expression mass{};
  components first_moment{};            ///< ∫ r dm
  symmetric inertia{};                  ///< ∫ (r·r E − r r) dm
  base::sequence<components> angular{}; ///< by amplitude: ∫ r × ∂r/∂q_k dm
  symbolic::matrix modal_mass{};        ///< ∫ ∂r/∂q_k · ∂r/∂q_l dm, constant
  definite_inertia definite{};          ///< if it is given, of a body that is moved by speeds
  beam_outline outline{};               ///< of a beam, for pictures
  nodes_for_pictures nodes{};           ///< of a body that is given by numbers
};

} // namespace kanexpr::mechanics
