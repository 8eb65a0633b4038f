#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/functions.hpp>

namespace kanexpr {

namespace describe {

/// The rate of the activation a for an excitation e, which rises with the time constant T_a and falls with
/// T_d:
///
///     ȧ = [(½ + f)/(T_a (½ + 3a/2)) + (½ − f) (½ + 3a/2)/T_d] (e − a),   f = ½ tanh(10 (e − a))
///
/// De Groote, Kinney, Rao & Fregly, Evaluation of direct collocation optimal control problem formulations for
/// solving the muscle redundancy problem, Annals of Biomedical Engineering 44 (2016), equations (1) and (2).
template <class Activation, class Excitation, class Rise, class Fall>
constexpr auto activation_rate(const Activation& a, const Excitation& e, const Rise& rising,
                               const Fall& falling) {
  const auto difference = e - a;
  const auto shape = 0.5 + 1.5 * a;
  const auto f = 0.5 * tanh(10.0 * difference);
  const auto up = 0.5 + f;
  const auto down = 0.5 - f;
  const auto rate_up = up / (rising * shape);
  const auto rate_down = down * shape / falling;
  return (rate_up + rate_down) * difference;
}

} // namespace describe

/// The activation of a muscle by an excitation between 0 and 1, which rises with the time constant Ta and
/// falls with Td: `struct Biceps : muscle_activation<Biceps, e, Ta, Td> {}`. `Biceps::output` is the state
/// variable a_Biceps. Usual times are 0.015 s and 0.06 s. De Groote et al. (2016).
template <class Self, auto... excitation_and_times>
struct muscle_activation : describe::block_words {
  static constexpr describe::state_variable_of<"a", Self> output{};

  static constexpr auto rise = describe::argument_or_zero<1, excitation_and_times...>();
  static constexpr auto fall = describe::argument_or_zero<2, excitation_and_times...>();
  static constexpr describe::block_record block =
      describe::requiring<describe::positive_of<"the time of activation of ", rise>,
                          describe::positive_of<"the time of deactivation of ", fall>>(
          describe::states_of_block<Self, output>::template with < dot(output) ==
          describe::activation_rate(output, describe::argument_or_zero<0, excitation_and_times...>(), rise,
                                    fall) >
              (describe::arguments_of("muscle_activation<Self, excitation, Ta, Td>",
                                      sizeof...(excitation_and_times), 3)));
};

} // namespace kanexpr
