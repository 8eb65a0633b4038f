#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

using numeric::beams::deformation;

/// A beam, with the dimensionless integrals over its shapes.
struct beam {
  base::name called{};
  int frame = -1; ///< the frame relative to which it deforms
  int root = -1;  ///< the point at x = 0 of the undeformed axis
  components axis{};
  components across[2]{}; ///< the directions of bending, perpendicular to the axis and to each other
  expression length{};
  expression mass_per_length{};
  expression polar_inertia{};                 ///< of the mass, per length
  expression stiffness[4]{};                  ///< by deformation: EI, EI, GJ, EA
  base::sequence<deformation> deformations{}; ///< by amplitude
  base::sequence<expression> amplitudes{};
  numeric::beams::modal_integrals integrals{};
  base::sequence<double> sections{}; ///< the numbers of an outline; empty if it is not drawn
};

constexpr beam_outline outline_of(const beam& b) {
  if (b.sections.empty()) return {};
  return {b.axis, {b.across[0], b.across[1]}, b.length, b.deformations, b.sections};
}

/// The beam whose outline a flexible body has, without its mass and stiffness.
constexpr beam outlined_beam(const flexible_body& f) {
  beam b;
  b.called = f.called;
  b.frame = f.frame;
  b.root = f.reference;
  b.axis = f.outline.axis;
  for (int i = 0; i < 2; ++i) b.across[i] = f.outline.across[i];
  b.length = b.mass_per_length = f.outline.length;
  b.deformations = f.outline.deformations;
  b.amplitudes = f.amplitudes;
  return b;
}

} // namespace kanexpr::mechanics
