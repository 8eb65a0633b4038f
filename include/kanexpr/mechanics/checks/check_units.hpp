#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertial_parameter.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/units/si.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// States the units of everything that a system consists of, and with them infers those of all symbols. Loads
/// state their own (`state_units`).
class system_units {
  // The templates precede their callers, because clang++ does not instantiate a template for a constant
  // expression if it is declared later in the class.
  static constexpr units::unit meter = units::si::meter, second = units::si::second, joule = units::si::joule,
                               kilogram = units::si::kilogram, radian = units::si::radian;

  template <int exponent>
  static constexpr units::unit pow(const units::unit& u) {
    return units::pow<exponent>(u);
  }

  template <class Quantity>
  constexpr void state(std::string_view what, const name& whose, const Quantity& quantity,
                       const units::unit& u) {
    by_.describe(what, whose.view());
    by_.expect(quantity, u);
  }
  template <class Quantity>
  constexpr void state(std::string_view what, const Quantity& quantity, const units::unit& u) {
    by_.describe(what, {});
    by_.expect(quantity, u);
  }
  /// States the units of all parts of a list from the given one on.
  template <class Part>
  constexpr void state_from(int first, const sequence<Part>& parts) {
    for (int i = first; i < parts.size(); ++i) state(parts[i]);
  }

public:
  constexpr system_units(const multibody_system& of, unit_inference& by)
      : of_(of), m_(of.mechanism), by_(by) {}

  /// Has no effect if the units of a model need not fit, because the model itself states none.
  constexpr void state() {
    by_.take_stated_units();
    if (!m_.checks_units()) return;
    if (!m_.flexible_bodies.empty()) mark_deformations();
    const parts_in_si_units& trusted = of_.in_si_units;
    state_from(trusted.frames, m_.frames);
    state_from(trusted.points, m_.points);
    state_from(trusted.bodies, m_.bodies);
    for (const expected_unit& e : m_.expected_units) {
      by_.describe(e.what.view(), e.whose.view());
      by_.expect(e.value, e.unit);
    }
    for (int i = trusted.kinematics; i < m_.kinematics.size(); ++i)
      state_equation("a kinematic differential equation", m_.kinematics[i]);
    if (of_.loads.has_gravity) state("gravity", of_.loads.gravity, meter / pow<2>(second));
    if (of_.loads.has_lagrangian) state("the Lagrangian", of_.loads.lagrangian, joule);
    load_units by(m_, by_);
    int kind = 0;
    of_.loads.each_kind([&](const auto& all) {
      for (int i = trusted.loads_of_kind(kind++); i < all.size(); ++i) all[i].state_units(by, i);
    });
    state_equations("a configuration constraint", of_.constraints.on_configuration);
    for (const velocity_constraint& c : of_.constraints.on_velocities)
      state_equation("a velocity constraint", c.value);
    state_equations("an acceleration constraint", of_.constraints.on_accelerations);
    for (const flexible_body& b : m_.flexible_bodies) state(b);
    if (!m_.flexible_bodies.empty()) suggest_deformations();
  }

private:
  constexpr void state(const frame& f) {
    if (f.is_by_angle() && !holds_amplitude(f.angle)) state("the angle of frame ", f.called, f.angle, radian);
    if (f.kind == orientation::matrix) {
      if (f.quaternion.empty())
        for (const parameter_rate& r : f.rates)
          state("a modified Rodrigues parameter of frame ", f.called, r.parameter, units::dimensionless);
      by_.describe("the orientation of frame ", f.called.view());
      for (const expression& e : f.quaternion) by_.expect(e, units::dimensionless);
      for (const expression& e : f.scalars())
        if (!holds_amplitude(e)) by_.expect(e, units::dimensionless);
    }
    if (f.has_declared_angular_velocity())
      state("the angular velocity of frame ", f.called, f.angular_velocity, radian / second);
  }

  constexpr void state(const point& p) {
    by_.describe("the offset of point ", p.called.view());
    p.offset.each_entry([&](expression e) {
      if (!holds_amplitude(e)) by_.expect(e, meter);
    });
    if (p.has_declared_velocity()) state("the velocity of point ", p.called, p.velocity, meter / second);
  }

  constexpr void state(const body& b) {
    state("the mass of ", b.called, b.mass, kilogram);
    state("the inertia of ", b.called, b.inertia, kilogram * pow<2>(meter));
  }

  /// The integrals of a flexible body may be numbers, which have units.
  constexpr void state(const flexible_body& b) {
    state("the mass of ", b.called, b.mass, kilogram);
    for (int k = 0; k < b.amplitudes.size(); ++k) {
      const expression rate = m_.coordinate_rates[m_.coordinates.find(b.amplitudes[k])];
      by_.suggest_coefficient(b.modal_mass(k, k), rate, joule);
    }
  }
  /// The places and angles that deform with flexible bodies.
  constexpr void suggest_deformations() {
    for (const point& p : m_.points)
      p.offset.each_entry([&](expression e) {
        if (holds_amplitude(e)) by_.suggest_amplitude(e, meter);
      });
    for (const frame& f : m_.frames)
      if (f.is_by_angle() && holds_amplitude(f.angle)) by_.suggest_amplitude(f.angle, radian);
  }
  constexpr bool holds_amplitude(expression e) const { return !deforms_.empty() && deforms_[e.node()] != 0; }
  /// Marks the nodes of the graph that contain an amplitude of a flexible body.
  constexpr void mark_deformations() {
    const symbolic::graph& g = *m_.g;
    deforms_.resize(g.size());
    for (const flexible_body& b : m_.flexible_bodies)
      for (const expression& q : b.amplitudes) deforms_[q.node()] = 1;
    for (int id = 0; id < g.size(); ++id) {
      if (symbolic::is_leaf(g[id].op)) continue;
      if (deforms_[g[id].a] != 0 || (symbolic::is_binary(g[id].op) && deforms_[g[id].b] != 0))
        deforms_[id] = 1;
    }
  }

  constexpr void state_equation(std::string_view what, expression difference) {
    by_.describe(what, {});
    by_.expect_equation(difference);
  }
  constexpr void state_equations(std::string_view what, const sequence<expression>& differences) {
    for (const expression& e : differences) state_equation(what, e);
  }

  const multibody_system& of_;
  const mechanism& m_;
  unit_inference& by_;
  sequence<char> deforms_{}; ///< by node; empty if no body is flexible
};

/// Reports units that do not fit; empty if there are none, or if the model itself states no unit.
constexpr sentence check_units(const multibody_system& of) {
  if (!of.mechanism.checks_units()) return {};
  unit_inference inferred(of.mechanism);
  system_units(of, inferred).state();
  return inferred.mistake();
}

/// The units of the symbols and equations of a system, from its inferred units.
constexpr unit_table unit_table_of(const multibody_system& of, unit_inference& inferred) {
  const mechanism& m = of.mechanism;
  unit_table table;
  table.is_stated = !m.stated_units.empty();
  const sequence<expression>* const symbols[]{&m.coordinates, &m.speeds, &m.parameters, &m.inputs,
                                              &m.auxiliary_speeds};
  for (int each = 0; each <= unit_table::auxiliary_speeds; ++each) {
    const auto to = static_cast<unit_table::list>(each);
    table.begin(to);
    for (const expression& e : *symbols[each]) table.put(to, e, inferred);
  }
  const given_constraints& c = of.constraints;
  for (const auto to : {unit_table::configuration_constraints, unit_table::redundant_constraints}) {
    table.begin(to);
    for (int i = 0; i < c.on_configuration.size(); ++i)
      if (c.redundant.contains(i + 1) == (to == unit_table::redundant_constraints))
        table.put(to, c.on_configuration[i], inferred);
  }
  table.begin(unit_table::velocity_constraints);
  for (const velocity_constraint& each : c.on_velocities)
    table.put(unit_table::velocity_constraints, each.value, inferred);
  table.begin(unit_table::acceleration_constraints);
  for (const expression& e : c.on_accelerations) table.put(unit_table::acceleration_constraints, e, inferred);
  table.begin(unit_table::kinematic_equations);
  for (const expression& e : m.kinematics) table.put(unit_table::kinematic_equations, e, inferred);
  for (const body& b : m.bodies) table.put_body(inertial_parameters_of(b) == 1);
  return table;
}

/// The units of the symbols and equations of a system.
constexpr unit_table unit_table_of(const multibody_system& of) {
  unit_inference inferred(of.mechanism);
  system_units(of, inferred).state();
  return unit_table_of(of, inferred);
}

} // namespace kanexpr::mechanics
