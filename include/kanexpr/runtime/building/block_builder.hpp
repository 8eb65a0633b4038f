#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/runtime/building/block_data.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/pathway_builder.hpp>
#include <kanexpr/runtime/building/scalar_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <initializer_list>
#include <string_view>

namespace kanexpr::runtime {

/// The filters, controllers, motors and muscles of a builder. Their state variables are named after them and
/// follow all speeds.
class block_builder : private builder_part {
public:
  /// A first-order lag with the state variable y_called, as `lag<Self, …>`. Returns its output.
  expression lag(std::string_view called, expression input, const number_or_expression& time);
  /// Follows an input with a limited rate, as `slew_limit<Self, …>`. Returns its output.
  expression slew_limit(std::string_view called, expression input, const number_or_expression& rate,
                        const number_or_expression& time);
  /// Delays an input approximately, with `order` state variables from 1 to 20, as `delay<Self, …>`. Returns
  /// its output.
  expression delay(std::string_view called, int order, expression input, const number_or_expression& time);
  /// A PID controller of a deviation, as `pid<Self, …>`. Returns its output.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& kd,
                 const number_or_expression& Td);
  /// The same without a derivative.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki);
  /// The same with limits of the output and the time constant Tt with which the integral part returns.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& least,
                 const number_or_expression& greatest, const number_or_expression& Tt);
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& kd,
                 const number_or_expression& Td, const number_or_expression& least,
                 const number_or_expression& greatest, const number_or_expression& Tt);
  /// The activation of a muscle by an excitation, as `muscle_activation<Self, …>`. Returns the activation.
  expression muscle_activation(std::string_view called, expression excitation, const number_or_expression& Ta,
                               const number_or_expression& Td);
  /// A DC motor that turns n times as fast as a joint with the given speed, as `dc_motor<Joint, …>`. Returns
  /// its current, the state variable i_called, and the torque, which the caller applies: `b.torque_between(A,
  /// N, b.along(N, 0, 0, motor.torque))`.
  dc_motor_states dc_motor(std::string_view called, expression speed, const dc_motor_data& data);
  /// A muscle with its tendon, as `muscle<Self, Path, …>`: `b.muscle("Biceps", path, e,
  /// {.peak_isometric_force = 500, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2})`. Returns its
  /// state variables.
  muscle_states muscle(std::string_view called, const pathway& along, expression excitation,
                       const muscle_data& data);

protected:
  explicit block_builder(builder_core& core, scalar_builder& scalars)
      : builder_part(core), scalars_(scalars) {}
  ~block_builder() = default;

private:
  expression state_of_block(std::string_view letter, std::string_view block, int number = 0);
  void equate(expression state, expression left, expression right);
  void must_be_positive(std::string_view what, std::string_view whose, expression value);
  base::sequence<expression> arguments_of_block(std::string_view block,
                                                std::initializer_list<number_or_expression> given);

  scalar_builder& scalars_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/block_builder.ipp>
#endif
