#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The axis of a beam and the values of its shapes at equally spaced sections, from which figures and
/// pictures draw it. Only models that are derived at run time have outlines.
struct beam_outline {
  static constexpr int sections = 9;

  components axis{};
  base::sequence<components> across{}; ///< the two directions of bending; zero if the beam lacks one
  symbolic::expression length{};
  base::sequence<numeric::beams::deformation> deformations{}; ///< by amplitude
  base::sequence<double> numbers{}; ///< the `section_values` of all sections; empty if there is no outline

  constexpr bool is_given() const { return !numbers.empty(); }
  constexpr numeric::beams::section_values section(int i) const {
    const int shapes = deformations.size(), first = i * numeric::beams::section_values::count(shapes);
    return {numbers.begin() + first, shapes};
  }

  /// A stage of a derivation at compile time does not store outlines.
  template <class Self, class Visit>
  static constexpr void each_member(Self&, Visit&&) {}
};

} // namespace kanexpr::mechanics
