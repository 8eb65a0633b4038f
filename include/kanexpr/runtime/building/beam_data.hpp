#pragma once

#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/numeric/beams/integrate_modes.hpp>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/runtime/building/builder_checks.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace kanexpr::runtime {

/// The index of a beam of a builder.
enum class beam_id : int {};

/// A section of a beam, as a frame and a point.
struct section_ids {
  frame_id frame{};
  point_id point{};
};

/// A deformation of a beam in a builder: its stiffness EI, GJ or EA, the factor by which the stiffness varies
/// along the beam, and its shapes, functions of ξ = x/L. Shapes must leave the root at rest unless
/// `moves_root`.
struct beam_deformation {
  number_or_expression stiffness;
  std::vector<numeric::beams::shape> shapes{};
  numeric::beams::shape profile = numeric::beams::shape::polynomial({1.0});
  bool moves_root = false;
};

/// The description of a beam in a builder. Its mass and its polar inertia are given per length; each varies
/// along the beam by the factor of its profile.
struct beam_data {
  struct bending {
    mechanics::vector direction{};
    beam_deformation by;
  };
  struct torsion {
    number_or_expression polar_inertia;
    beam_deformation by;
    numeric::beams::shape profile = numeric::beams::shape::polynomial({1.0}); ///< of the polar inertia
  };

  mechanics::vector axis{};
  number_or_expression length;
  number_or_expression mass_per_length;
  std::vector<beam_data::bending> bending{}; ///< in one direction or in two
  std::optional<beam_data::torsion> torsion{};
  std::optional<beam_deformation> extension{};
  numeric::beams::shape mass_profile = numeric::beams::shape::polynomial({1.0});
  /// Proportional damping, a factor of the mass matrix and one of the stiffness matrix.
  number_or_expression damping_of_mass = 0.0, damping_of_stiffness = 0.0;
  std::vector<number_or_expression> damping_ratios{}; ///< of all shapes, or one for all
};

/// The first natural modes of bending of a uniform beam, for `beam_deformation::shapes`.
inline std::vector<numeric::beams::shape> modes_of_bending(numeric::beams::ends how, int count,
                                                           const numeric::beams::tip_load& tip = {}) {
  std::vector<numeric::beams::shape> all;
  all.reserve(static_cast<std::size_t>(count > 0 ? count : 0));
  for (int n = 1; n <= count; ++n) all.push_back(numeric::beams::mode_of_bending(how, n, tip));
  return all;
}

/// The first natural modes of a uniform rod in torsion or extension.
inline std::vector<numeric::beams::shape> modes_of_rod(numeric::beams::ends how, int count,
                                                       const numeric::beams::tip_load& tip = {}) {
  std::vector<numeric::beams::shape> all;
  all.reserve(static_cast<std::size_t>(count > 0 ? count : 0));
  for (int n = 1; n <= count; ++n) all.push_back(numeric::beams::mode_of_rod(how, n, tip));
  return all;
}

} // namespace kanexpr::runtime
