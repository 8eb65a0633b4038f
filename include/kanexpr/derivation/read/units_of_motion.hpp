#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/reading.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

/// When a model is read to infer units, everything whose unit is known without its value is a symbol with
/// this unit: positions, velocities and accelerations, and the numbers of a function that takes them with a
/// unit.
namespace kanexpr::derivation {

constexpr expression symbol_of_unit(reading& in, const base::name& called, const units::unit& u) {
  const expression e = symbolic::variable(*in.into.mechanism.g, {symbolic::symbol_kind::input, called, none});
  in.state_unit({e, u, true});
  return e;
}

/// A vector with components of a unit, along the inertial axes: `velocity_of<P>`.
constexpr mechanics::vector vector_of_unit(reading& in, std::string_view word, std::string_view whose,
                                           const units::unit& u) {
  mechanics::vector v;
  components value;
  for (int i = 0; i < 3; ++i) {
    base::name called = word;
    called.append("<"), called.append(whose), called.append(">.");
    called.append(std::string_view("xyz").substr(static_cast<std::size_t>(i), 1));
    value[i] = symbol_of_unit(in, called, u);
  }
  v.add(mechanism::inertial, value);
  return v;
}

/// The motion that a token denotes.
constexpr mechanics::vector motion_of_unit(reading& in, const describe::token& t) {
  using describe::token_kind;
  const units::unit meter = units::si::meter, hertz = units::si::hertz, radian = units::si::radian;
  switch (t.what) {
  case token_kind::position: return vector_of_unit(in, "position_of", t.point->called, meter);
  case token_kind::velocity: return vector_of_unit(in, "velocity_of", t.point->called, meter * hertz);
  case token_kind::acceleration:
    return vector_of_unit(in, "acceleration_of", t.point->called, meter * hertz * hertz);
  case token_kind::angular_velocity:
    return vector_of_unit(in, "angular_velocity_of", t.frame->called, radian * hertz);
  default: return vector_of_unit(in, "angular_acceleration_of", t.frame->called, radian * hertz * hertz);
  }
}

/// A quantity with the unit of the derivative of another with respect to time.
constexpr void divide_by_second(reading& in, value& of) {
  const expression per_second = symbol_of_unit(in, "d/dt", units::si::hertz);
  if (of.kind == shape::scalar) of.scalar = per_second * of.scalar;
  for (mechanics::vector::part& p : of.vector.parts)
    for (int i = 0; i < 3; ++i) p.value[i] = per_second * p.value[i];
}

/// A quantity with the unit of the derivative of another with respect to a symbol.
constexpr void divide_by(expression symbol, value& of) {
  if (of.kind == shape::scalar) of.scalar = of.scalar / symbol;
  for (mechanics::vector::part& p : of.vector.parts)
    for (int i = 0; i < 3; ++i) p.value[i] = p.value[i] / symbol;
}

/// A symbol that differs from all others, even from those of the same name.
constexpr expression new_symbol(symbolic::graph& g, symbolic::symbol_kind kind, const base::name& called) {
  return symbolic::variable(g, {kind, called, none - 1 - g.symbols().size()});
}

/// Replaces a number that is a whole quantity by a symbol, because it has the unit that is expected there.
constexpr expression as_symbol(reading& in, expression e) {
  if (!e.is_constant() || e.is_zero()) return e;
  symbolic::graph& g = *in.into.mechanism.g;
  return new_symbol(g, symbolic::symbol_kind::parameter, symbolic::short_text(g, e.node()).view());
}

/// The value of a composed function as a symbol that is written like the function in the model:
/// smooth_step(x, 0, l). Its unit follows from the operands.
constexpr expression value_of_function(reading& in, const symbolic::composite_signature& f,
                                       const sequence<expression>& operands) {
  mechanism& m = in.into.mechanism;
  base::name called = f.name;
  for (int i = 0; i < operands.size(); ++i) {
    called.append(i == 0 ? "(" : ", ");
    called.append(symbolic::short_text(*m.g, operands[i].node()).view());
  }
  called.append(")");
  const expression symbol = new_symbol(*m.g, symbolic::symbol_kind::input, called);
  m.function_values.push({symbol, f.is, operands});
  return symbol;
}

/// The value of a table: a symbol of unknown unit if all its values are numbers, otherwise one of its values.
constexpr expression value_of_table(reading& in, const sequence<expression>& operands) {
  for (int i = 2; i < operands.size(); i += 2)
    if (!operands[i].is_constant()) return operands[i];
  base::name called = "table ";
  called.append(in.into.mechanism.g->symbols().size());
  return symbolic::variable(*in.into.mechanism.g, {symbolic::symbol_kind::input, called, none});
}

} // namespace kanexpr::derivation
