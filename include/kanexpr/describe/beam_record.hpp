#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>

#include <string_view>

namespace kanexpr::describe {

/// A beam as a model describes it, with the integrals over its shapes.
struct beam_record {
  std::string_view mistake{}; ///< the end of a sentence, such as "has no shapes"
  std::string_view form{};    ///< the correct form, if the beam is written incorrectly
  phrase axis{};
  phrase across[2]{}; ///< the directions of bending; empty if it does not bend in them
  phrase length{};
  phrase mass_per_length{};
  phrase polar_inertia{};
  phrase stiffness[4]{}; ///< by numeric::beams::deformation
  numeric::beams::modal_integrals integrals{};
  const numeric::beams::deformation* deformations = nullptr; ///< by amplitude
  base::sequence<double> (*sections)(int count) = nullptr;   ///< the values at equally spaced sections
  listing<phrase> coordinates{}, speeds{}, kinematics{};
  phrase damping_of_mass{}, damping_of_stiffness{}; ///< the factors of proportional damping
  listing<phrase> damping_ratios{};                 ///< of all shapes, or one for all
};

} // namespace kanexpr::describe
