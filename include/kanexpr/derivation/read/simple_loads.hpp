#pragma once

#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/phrase_units.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/spring_damper.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

/// Readers of forces, torques and energies, and of straight springs and dampers, and the units of their
/// phrases.
namespace kanexpr::derivation {

constexpr void read_force(load_parts& by) {
  const load_record& r = by.record;
  const auto [at, other] = by.points(r.other_point != nullptr ? by.whom : "a force"sv);
  const mechanics::vector v = by.effort(" at "sv);
  if (by.state().for_units && r.coefficient != nullptr) by.expect_unit(*r.coefficient, *r.point);
  if (!by.has_mistake()) by.into.forces.push({at, v, other});
}

constexpr void read_torque(load_parts& by) {
  const auto [on, other] = by.frames(by.record.other_frame != nullptr ? by.whom : "a torque"sv);
  const mechanics::vector v = by.effort(" on "sv);
  if (!by.has_mistake()) by.into.torques.push({on, v, other});
}

constexpr void read_gravity(load_parts& by) {
  if (by.into.has_gravity) by.fail({"gravity is listed twice"});
  const mechanics::vector v = by.vector(by.record.value, "");
  if (!by.has_mistake()) by.into.has_gravity = true, by.into.gravity = v;
}

constexpr void read_potential_energy(load_parts& by) {
  const expression energy = by.scalar(by.record.value, "");
  if (by.has_mistake()) return;
  if (energy.is_zero() && !by.holds_bound(by.record.value)) return by.fail({by.whom, " is zero"});
  by.into.potential_energies.push({energy});
}

constexpr void read_spring(load_parts& by) {
  const auto [at, other] = by.points();
  const expression stiffness = by.scalar(by.record.value, "the stiffness of "sv);
  const expression length = by.scalar(by.record.rest, "the natural length of "sv);
  if (!by.has_mistake()) mechanics::add_spring(by.into.spring_dampers, at, other, stiffness, length);
}

constexpr void read_damper(load_parts& by) {
  const auto [at, other] = by.points();
  const expression damping = by.scalar(by.record.value, "the damping of "sv);
  if (!by.has_mistake()) mechanics::add_damper(by.into.spring_dampers, at, other, damping);
}

constexpr void read_torsional_spring(load_parts& by) {
  const expression angle = by.scalar(by.record.angle, "the angle of "sv);
  const expression stiffness = by.scalar(by.record.value, "the stiffness of "sv);
  const expression rest = by.scalar(by.record.rest, "the rest angle of "sv);
  reading& all = by.state();
  if (!all.mistake)
    all.mistake = mechanics::check_torsional_spring(by.model(), angle, stiffness, rest, by.whom);
  if (!all.mistake) by.into.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
}

constexpr void read_torsional_damper(load_parts& by) {
  const auto [on, other] = by.frames();
  const expression damping = by.scalar(by.record.value, "the damping of "sv);
  if (!by.has_mistake()) by.into.torsional_dampers.push({on, other, damping});
}

constexpr void expect_force(const load_record& r, phrase_units& by) { by.expect(r.value, units::si::newton); }
constexpr void expect_torque(const load_record& r, phrase_units& by) { by.expect(r.value, units::si::joule); }
constexpr void expect_energy(const load_record& r, phrase_units& by) { by.expect(r.value, units::si::joule); }
constexpr void expect_gravity(const load_record& r, phrase_units& by) {
  by.expect(r.value, units::si::newton / units::si::kilogram);
}
constexpr void expect_spring(const load_record& r, phrase_units& by) {
  by.expect(r.value, units::si::newton / units::si::meter);
  by.expect(r.rest, units::si::meter);
}
constexpr void expect_damper(const load_record& r, phrase_units& by) {
  by.expect(r.value, units::si::newton * units::si::second / units::si::meter);
}
constexpr void expect_torsional_spring(const load_record& r, phrase_units& by) {
  const unit_product angle = by.unit_of(r.angle);
  by.equate(angle, by.unit_of(r.rest));
  by.expect_energy(by.unit_of(r.value), angle);
}
constexpr void expect_torsional_damper(const load_record& r, phrase_units& by) {
  by.expect(r.value, units::si::joule * units::si::second);
}

} // namespace kanexpr::derivation
