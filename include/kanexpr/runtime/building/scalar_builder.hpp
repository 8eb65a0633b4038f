#pragma once

#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/compose.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// The scalars of a builder and their equations.
class scalar_builder : private builder_part {
public:
  // Each symbol may be given with its unit, such as `units::si::newton*units::si::meter`.

  expression coordinate(std::string_view q) { return checks_.is_new_symbol(q), m_.coordinate(q); }
  expression coordinate(std::string_view q, const units::unit& u) { return with_unit(coordinate(q), u); }
  expression speed(std::string_view u) { return checks_.is_new_speed(u), m_.speed(u); }
  expression speed(std::string_view u, const units::unit& of) { return with_unit(speed(u), of); }
  /// A scalar that is neither a coordinate nor a speed; `dynamics` gives its rate. State variables follow all
  /// speeds.
  expression state_variable(std::string_view z) { return checks_.is_new_symbol(z), m_.state_variable(z); }
  expression state_variable(std::string_view z, const units::unit& u) {
    return with_unit(state_variable(z), u);
  }
  expression parameter(std::string_view p) { return checks_.is_new_symbol(p), m_.parameter(p); }
  expression parameter(std::string_view p, const units::unit& u) { return with_unit(parameter(p), u); }
  expression input(std::string_view r) { return checks_.is_new_symbol(r), m_.input(r); }
  expression input(std::string_view r, const units::unit& u) { return with_unit(input(r), u); }
  /// A quantity that is a known function of time. It adds three consecutive inputs: r, dot(r) and
  /// dot(dot(r)).
  expression prescribed(std::string_view r);
  expression prescribed(std::string_view r, const units::unit& u) { return with_unit(prescribed(r), u); }
  /// Declares that a parameter or an input is used by expressions that are requested later; any other unused
  /// parameter or input is a mistake.
  void used_elsewhere(expression parameter_or_input);
  /// A speed that is always zero; it brings a force that does no work into evidence.
  expression auxiliary_speed(std::string_view u) { return checks_.is_new_symbol(u), m_.auxiliary_speed(u); }
  expression auxiliary_speed(std::string_view u, const units::unit& of) {
    return with_unit(auxiliary_speed(u), of);
  }
  /// Selects Lagrange's method: the rates of the coordinates declared so far are used as speeds.
  void rates_as_speeds();
  /// Specifies a Lagrangian instead of bodies; call it after `rates_as_speeds`.
  void lagrangian(expression energy);
  expression time() { return checks_.take_time(), m_.time; }
  /// A constant; write zero as 0.0.
  expression number(given_number value) { return constant(value); }

  /// The rate of a coordinate, speed, state variable or prescribed quantity.
  expression dot(expression e);

  /// A kinematic differential equation: an expression that vanishes and is linear in the rates of the
  /// coordinates, such as `dot(q) - u`.
  void kinematic_equation(expression vanishes) {
    if (checks_.owns("a kinematic differential equation", vanishes)) m_.kinematics.push(vanishes);
  }
  /// The rate of a state variable. It may depend on everything except the rates of the speeds.
  void dynamics(expression state_variable, expression rate);
  /// The equations that equate the angular velocity derived from the orientation of a frame with the declared
  /// one.
  void kinematics_of(frame_id frame, frame_id reference);

protected:
  explicit scalar_builder(builder_core& core) : builder_part(core) {}
  ~scalar_builder() = default;

private:
  expression with_unit(expression symbol, const units::unit& u) {
    m_.stated_units.push({symbol, u});
    return symbol;
  }
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/scalar_builder.ipp>
#endif
