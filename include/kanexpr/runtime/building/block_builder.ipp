#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/blocks/activation.hpp>
#include <kanexpr/describe/blocks/dc_motor.hpp>
#include <kanexpr/describe/blocks/delay.hpp>
#include <kanexpr/describe/blocks/lag.hpp>
#include <kanexpr/describe/blocks/pid.hpp>
#include <kanexpr/mechanics/checks/check_name.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/rotor.hpp>
#include <kanexpr/runtime/building/block_builder.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace kanexpr::runtime {

/// A state variable named after a block: y_Filter, or m_Late1.
KANEXPR_ENGINE expression block_builder::state_of_block(std::string_view letter, std::string_view block,
                                                        int number) {
  base::name called = letter;
  called.append("_"), called.append(block);
  if (number > 0) called.append(number);
  return scalars_.state_variable(called.view());
}

/// Gives the rate of a state variable by the difference of the sides of an equation.
KANEXPR_ENGINE void block_builder::equate(expression state, expression left, expression right) {
  if (has_mistake()) return;
  const mechanics::solved_state_rate solved =
      mechanics::solve_for_state_rate(m_, m_.speeds.find(state), left - right);
  if (solved.mistake)
    checks_.fail({solved.mistake.view()});
  else
    system_.loads.state_rates.push(solved.found);
}

/// Requires a constant of a block or a motor to be positive.
KANEXPR_ENGINE void block_builder::must_be_positive(std::string_view what, std::string_view whose,
                                                    expression value) {
  base::name of = what;
  of.append(whose);
  if (!has_mistake()) system_.loads.positive_constants.push({value, of});
}

/// The arguments of a block as expressions; empty if they are not valid.
KANEXPR_ENGINE base::sequence<expression>
block_builder::arguments_of_block(std::string_view block, std::initializer_list<number_or_expression> given) {
  base::sequence<expression> all;
  if (const sentence found = mechanics::check_name(block, "blocks")) checks_.fail({found.view()});
  const sentence whose({"block ", block}), zero({"an argument of block ", block, " is 0"});
  for (const number_or_expression& each : given)
    if (each.is_whole_zero())
      checks_.fail_integer_zero(zero.view());
    else
      all.push(as_expression(each));
  return checks_.owns(whose.view(), all) && !has_mistake() ? all : base::sequence<expression>{};
}

KANEXPR_ENGINE expression block_builder::lag(std::string_view called, expression input,
                                             const number_or_expression& time) {
  const base::sequence<expression> given = arguments_of_block(called, {input, time});
  if (given.empty()) return m_.zero();
  const expression y = state_of_block("y", called);
  if (!has_mistake()) equate(y, given[1] * scalars_.dot(y), given[0] - y);
  must_be_positive("the time constant of block ", called, given[1]);
  return y;
}

KANEXPR_ENGINE expression block_builder::slew_limit(std::string_view called, expression input,
                                                    const number_or_expression& rate,
                                                    const number_or_expression& time) {
  const base::sequence<expression> given = arguments_of_block(called, {input, rate, time});
  if (given.empty()) return m_.zero();
  const expression y = state_of_block("y", called);
  must_be_positive("the rate of block ", called, given[1]);
  must_be_positive("the time constant of block ", called, given[2]);
  if (!has_mistake()) equate(y, scalars_.dot(y), describe::limited_rate(given[0], y, given[1], given[2]));
  return y;
}

KANEXPR_ENGINE expression block_builder::delay(std::string_view called, int order, expression input,
                                               const number_or_expression& time) {
  const base::sequence<expression> given = arguments_of_block(called, {input, time});
  if (order < 1 || order > 20)
    checks_.fail({"expected an order of block ", called, " from 1 to 20, got ", base::counted(order).view()});
  if (given.empty() || has_mistake()) return m_.zero();
  base::sequence<expression> m;
  for (int i = 0; i < order && !has_mistake(); ++i) m.push(state_of_block("m", called, i + 1));
  if (has_mistake()) return m_.zero();
  expression output = m[order - 1];
  for (int i = order - 2; i >= 0; --i) output = m[i] + output;
  for (int i = 0; i < order; ++i) {
    expression sum = describe::legendre_sign(i, order - 1) * m[order - 1];
    for (int j = order - 2; j >= 0; --j) {
      const expression term = describe::legendre_sign(i, j) * m[j];
      sum = term + sum;
    }
    const expression forced = sum + describe::legendre_sign_of_input(i) * given[0];
    const expression right = (2.0 * i + 1) * forced;
    equate(m[i], given[1] * scalars_.dot(m[i]), right);
  }
  must_be_positive("the time of block ", called, given[1]);
  return output;
}

KANEXPR_ENGINE expression block_builder::pid(std::string_view called, expression deviation,
                                             const number_or_expression& kp, const number_or_expression& ki) {
  const base::sequence<expression> given = arguments_of_block(called, {deviation, kp, ki});
  if (given.empty()) return m_.zero();
  const expression s = state_of_block("s", called);
  if (has_mistake()) return m_.zero();
  equate(s, scalars_.dot(s), given[2] * given[0]);
  return given[1] * given[0] + s;
}

KANEXPR_ENGINE expression block_builder::pid(std::string_view called, expression deviation,
                                             const number_or_expression& kp, const number_or_expression& ki,
                                             const number_or_expression& least,
                                             const number_or_expression& greatest,
                                             const number_or_expression& Tt) {
  const base::sequence<expression> given =
      arguments_of_block(called, {deviation, kp, ki, least, greatest, Tt});
  if (given.empty()) return m_.zero();
  const expression s = state_of_block("s", called);
  if (has_mistake()) return m_.zero();
  const expression v = given[1] * given[0] + s;
  const expression limited = describe::limited_output(v, given[3], given[4]);
  equate(s, scalars_.dot(s), describe::rate_of_integral_part(given[0], given[2], limited, v, given[5]));
  must_be_positive("the time constant of the integral part of block ", called, given[5]);
  must_be_positive("the distance between the limits of block ", called, given[4] - given[3]);
  return limited;
}

KANEXPR_ENGINE expression block_builder::pid(std::string_view called, expression deviation,
                                             const number_or_expression& kp, const number_or_expression& ki,
                                             const number_or_expression& kd, const number_or_expression& Td) {
  const base::sequence<expression> given = arguments_of_block(called, {deviation, kp, ki, kd, Td});
  if (given.empty()) return m_.zero();
  const expression s = state_of_block("s", called), d = state_of_block("d", called);
  if (has_mistake()) return m_.zero();
  equate(s, scalars_.dot(s), given[2] * given[0]);
  equate(d, given[4] * scalars_.dot(d), given[0] - d);
  must_be_positive("the time constant of the filter of block ", called, given[4]);
  return describe::unlimited_output(given[0], s, d, given[1], given[3], given[4]);
}

KANEXPR_ENGINE expression block_builder::pid(std::string_view called, expression deviation,
                                             const number_or_expression& kp, const number_or_expression& ki,
                                             const number_or_expression& kd, const number_or_expression& Td,
                                             const number_or_expression& least,
                                             const number_or_expression& greatest,
                                             const number_or_expression& Tt) {
  const base::sequence<expression> given =
      arguments_of_block(called, {deviation, kp, ki, kd, Td, least, greatest, Tt});
  if (given.empty()) return m_.zero();
  const expression s = state_of_block("s", called), d = state_of_block("d", called);
  if (has_mistake()) return m_.zero();
  const expression v = describe::unlimited_output(given[0], s, d, given[1], given[3], given[4]);
  const expression limited = describe::limited_output(v, given[5], given[6]);
  equate(s, scalars_.dot(s), describe::rate_of_integral_part(given[0], given[2], limited, v, given[7]));
  equate(d, given[4] * scalars_.dot(d), given[0] - d);
  must_be_positive("the time constant of the integral part of block ", called, given[7]);
  must_be_positive("the distance between the limits of block ", called, given[6] - given[5]);
  must_be_positive("the time constant of the filter of block ", called, given[4]);
  return limited;
}

KANEXPR_ENGINE expression block_builder::muscle_activation(std::string_view called, expression excitation,
                                                           const number_or_expression& Ta,
                                                           const number_or_expression& Td) {
  const base::sequence<expression> given = arguments_of_block(called, {excitation, Ta, Td});
  if (given.empty()) return m_.zero();
  const expression a = state_of_block("a", called);
  must_be_positive("the time of activation of block ", called, given[1]);
  must_be_positive("the time of deactivation of block ", called, given[2]);
  if (!has_mistake()) equate(a, scalars_.dot(a), describe::activation_rate(a, given[0], given[1], given[2]));
  return a;
}

KANEXPR_ENGINE dc_motor_states block_builder::dc_motor(std::string_view called, expression speed,
                                                       const dc_motor_data& data) {
  const dc_motor_states none{m_.zero(), {}, m_.zero()};
  const base::sequence<expression> given =
      arguments_of_block(called, {data.voltage, data.resistance, data.inductance, data.torque_constant,
                                  data.gear_ratio, data.friction, speed});
  if (given.empty()) return none;
  const expression k = given[3], n = given[4], b = given[5], u = given[6];
  must_be_positive("the resistance of the motor ", called, given[1]);
  must_be_positive("the inductance of the motor ", called, given[2]);
  expression resistance = given[1];
  dc_motor_states states{state_of_block("i", called), {}, {}};
  if (data.winding) {
    const base::sequence<expression> winding =
        arguments_of_block(called, {data.winding->temperature_coefficient, data.winding->heat_capacity,
                                    data.winding->thermal_resistance});
    if (winding.empty()) return none;
    states.heating = state_of_block("heat", called);
    must_be_positive("the heat capacity of the motor ", called, winding[1]);
    must_be_positive("the thermal resistance of the motor ", called, winding[2]);
    resistance = describe::warm_resistance(resistance, winding[0], states.heating);
    if (!has_mistake())
      equate(states.heating, winding[1] * scalars_.dot(states.heating),
             describe::heat_flow(resistance, states.current, states.heating, winding[2]));
  }
  if (has_mistake()) return none;
  const expression induced = k * (n * u);
  equate(states.current, given[2] * scalars_.dot(states.current),
         describe::inductive_voltage(given[0], resistance, states.current, induced));
  const expression driving = n * k * states.current, braking = n * n * b * u;
  states.torque = driving - braking;
  return states;
}

KANEXPR_ENGINE muscle_states block_builder::muscle(std::string_view called, const pathway& along,
                                                   expression excitation, const muscle_data& data) {
  muscle_states states{m_.zero(), {}, {}};
  mechanics::muscle made;
  made.called = called, made.along = along, made.formulation = data.formulation;
  expression* const values[]{&made.peak_force,       &made.optimal_length, &made.slack_length,
                             &made.maximal_velocity, &made.pennation,      &made.damping,
                             &made.tendon_strain,    &made.passive_strain};
  const number_or_expression* const given[]{&data.peak_isometric_force,
                                            &data.optimal_fiber_length,
                                            &data.tendon_slack_length,
                                            &data.maximal_fiber_velocity,
                                            &data.pennation,
                                            &data.fiber_damping,
                                            &data.tendon_strain,
                                            &data.passive_strain};
  base::sequence<expression> terms{excitation};
  const sentence whose({"the muscle ", called}), value({"a parameter of the muscle ", called});
  for (std::size_t i = 0; i < std::size(given); ++i)
    terms.push(*values[i] = as_nonzero(*given[i], value.view()));
  if (!checks_.is_new("muscles", called, system_.loads.all<mechanics::muscle>())) return states;
  if (!checks_.owns_path_load(whose.view(), along, terms)) return states;
  states.activation =
      data.has_activation_dynamics
          ? muscle_activation(called, excitation, data.activation_time, data.deactivation_time)
          : excitation;
  if (data.formulation != muscle_formulation::rigid_tendon)
    states.tendon_state =
        state_of_block(data.formulation == muscle_formulation::tendon_force ? "F" : "l", called);
  made.activation = states.activation, made.tendon_state = states.tendon_state;
  if (has_mistake()) return states;
  system_.loads.add(made);
  states.load = made;
  if (made.tendon_state.is_given())
    system_.loads.state_rates.push({m_.speeds.find(made.tendon_state), {}, {}});
  return states;
}

} // namespace kanexpr::runtime
