#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/load_table.hpp>
#include <kanexpr/derivation/read/phrase_units.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the units of a model from its phrases, without their values. This costs the compiler a small part of
/// what `model_units` costs, which is needed only if units do not fit, to find the sentence.
class unit_reader : part_reader {
public:
  using part_reader::part_reader;

  /// Whether all units fit; false also if this reader cannot decide it. Requires that the model was read
  /// without a mistake.
  constexpr bool fit() {
    const system_record& from = reading_.from;
    for (const frame_record* r : entities_.frames_read()) read(*r);
    for (const point_record* r : entities_.points_read()) read(*r);
    for (const describe::body_record& r : from.bodies) read(r);
    for (const describe::joint_record& r : from.joints) read(r);
    for (const load_record& r : from.loads) read(r);
    read_dynamics();
    for (const phrase& p : from.lagrangian) units_.expect(p, joule);
    for (const phrase& p : from.kinematics)
      if (p.kind == shape::equation) units_.unit_of(p);
    read_simple_kinematics();
    for (const auto* equations : {&from.configuration_constraints, &from.velocity_constraints,
                                  &from.acceleration_constraints, &from.dependent, &from.used_elsewhere})
      for (const phrase& p : *equations) units_.unit_of_components(p);
    return units_.fit();
  }

private:
  static constexpr units::unit meter = units::si::meter, second = units::si::second, joule = units::si::joule,
                               kilogram = units::si::kilogram, newton = units::si::newton,
                               radian = units::si::radian;

  constexpr void read(const frame_record& r) {
    for (const phrase& p : r.given) {
      if (p.kind == shape::nothing) break;
      units_.expect(p, radian); // a number fits, too
    }
    units_.unit_of_components(r.axis);
    if (r.angular_velocity.kind == shape::nothing) return;
    const unit_product found = units_.unit_of_components(r.angular_velocity);
    if (found.fits_all) units_.fail(); // the rates of angles may depend on its components
    units_.equate(found, mechanics::known_unit(radian / second));
  }
  constexpr void read(const point_record& r) {
    units_.expect(r.offset, meter);
    units_.expect(r.velocity, meter / second);
  }

  constexpr void read(const describe::body_record& r) {
    if (r.beam != nullptr || r.flexible != nullptr) return units_.fail(); // their amplitudes have any unit
    units_.expect(r.mass, kilogram);
    if (!r.rigid) return;
    const units::unit moment = kilogram * meter * meter;
    if (r.inertia_axes == nullptr) return units_.expect(r.inertia_dyadic, moment);
    for (const phrase& p : r.inertia) units_.expect(p, moment);
  }

  constexpr void read(const describe::joint_record& r) {
    if (r.rotor != nullptr || r.stops != nullptr) return units_.fail(); // read by other readers
    for (const phrase& p : r.axes) units_.unit_of_components(p);
    units_.unit_of(r.place);
    for (const phrase& p : r.kinematics) units_.unit_of(p);
    if (r.body != nullptr) read(*r.body);
  }

  constexpr void read(const load_record& r) {
    if (r.rotor != nullptr) return units_.fail(); // read by another reader
    if (r.coefficient != nullptr) units_.expect(r.coefficient->value, r.coefficient->unit);
    if (r.what == load_word::none) return;
    if (row_of(r).expect_units == nullptr) return units_.fail();
    row_of(r).expect_units(r, units_);
  }

  /// Reads the equations for the rates of state variables.
  constexpr void read_dynamics() {
    for (const phrase& p : reading_.from.dynamics) units_.unit_of(p);
    for (const describe::block_record& r : reading_.from.blocks)
      for (const phrase& p : r.dynamics) units_.unit_of(p);
    for (const load_record& r : reading_.from.loads)
      for (const phrase& p : r.dynamics) units_.unit_of(p);
  }

  /// Reads the equations that `simple` adds.
  constexpr void read_simple_kinematics() {
    bool has_simple = false;
    for (const phrase& p : reading_.from.kinematics) has_simple = has_simple || p.kind == shape::simple;
    if (!has_simple) return;
    const symbolic::graph& g = *m_.g;
    for (const expression& e : m_.kinematics) {
      const symbolic::node& n = g[e.node()];
      if (n.op != symbolic::operation::subtract || g[n.a].op != symbolic::operation::symbol ||
          g[n.b].op != symbolic::operation::symbol)
        continue;
      const symbolic::symbol &rate = g.symbol_at(n.a), &speed = g.symbol_at(n.b);
      if (rate.kind != symbolic::symbol_kind::coordinate_rate || speed.kind != symbolic::symbol_kind::speed)
        continue;
      const expression coordinate = m_.coordinates[rate.position];
      units_.expect_rate(g.symbol_at(coordinate.node()).called, speed.called);
    }
  }

  phrase_units units_{};
};

} // namespace kanexpr::derivation
