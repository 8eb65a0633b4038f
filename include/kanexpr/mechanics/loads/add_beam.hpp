#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/modal_damping.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_expressions.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The structural damping of a beam: the matrix of_mass·M + of_stiffness·K, or a damping ratio for each
/// amplitude or one for all.
struct beam_damping {
  expression of_mass{}, of_stiffness{};
  sequence<expression> ratios{};
};

/// The damping matrix of the amplitudes. A damping ratio ζ_k gives D_kk = 2 ζ_k √(K_kk M_kk).
constexpr symbolic::matrix damping_matrix(const beam_damping& by, const symbolic::matrix& mass,
                                          const symbolic::matrix& stiffness) {
  symbolic::matrix damping = mass;
  for (int k = 0; k < mass.rows; ++k)
    for (int l = 0; l < mass.rows; ++l)
      damping(k, l) = by.of_mass * mass(k, l) + by.of_stiffness * stiffness(k, l);
  if (by.ratios.empty()) return damping;
  for (int k = 0; k < mass.rows; ++k) {
    const expression ratio = by.ratios[by.ratios.size() == 1 ? 0 : k];
    damping(k, k) += 2 * ratio * sqrt(mass(k, k) * stiffness(k, k));
  }
  return damping;
}

/// Reports a negative factor or ratio of damping.
constexpr sentence check_damping(const beam_damping& by, std::string_view beam) {
  const auto is_negative = [](expression e) {
    return e.is_constant() && e.owner().number_at(e.node()).negative();
  };
  bool found = is_negative(by.of_mass) || is_negative(by.of_stiffness);
  for (const expression& e : by.ratios) found = found || is_negative(e);
  return found ? sentence({"the damping of beam ", beam, " is negative"}) : sentence();
}

/// States the units of the properties and the amplitudes of a beam. The shapes have no unit, so the amplitude
/// of a displacement is a length and that of torsion an angle.
constexpr void expect_units_of(mechanism& m, const beam& b) {
  const units::unit meter = units::si::meter, kilogram = units::si::kilogram, newton = units::si::newton;
  m.expected_units.push({b.length, meter, "the length of beam ", b.called});
  m.expected_units.push({b.mass_per_length, kilogram / meter, "the mass per length of beam ", b.called});
  m.expected_units.push({b.polar_inertia, kilogram * meter, "the polar inertia of beam ", b.called});
  for (const deformation d : b.deformations)
    m.expected_units.push({b.stiffness[static_cast<int>(d)],
                           d == deformation::extension ? newton : newton * meter * meter,
                           "a stiffness of beam ", b.called});
  for (int k = 0; k < b.amplitudes.size(); ++k)
    m.expected_units.push({b.amplitudes[k],
                           b.deformations[k] == deformation::torsion ? units::si::radian : meter,
                           "an amplitude of beam ", b.called});
}

/// Adds a beam to a mechanism: the flexible body, its elastic energy and its damping.
constexpr void add_beam(mechanism& m, loads& acting, const beam& b, const beam_damping& damped) {
  const beam_expressions of(b);
  expect_units_of(m, b);
  m.flexible_bodies.push(of.body());
  const symbolic::matrix stiffness = of.stiffness();
  acting.potential_energies.push(elastic_energy(b.amplitudes, stiffness));
  const symbolic::matrix damping = damping_matrix(damped, of.modal_mass(), stiffness);
  bool is_damped = false;
  for (const expression& e : damping.entries) is_damped = is_damped || !e.is_zero();
  if (is_damped) acting.modal_dampings.push({b.amplitudes, damping});
}

} // namespace kanexpr::mechanics
