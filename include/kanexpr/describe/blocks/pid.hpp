#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/composed.hpp>

namespace kanexpr {

namespace describe {

/// A PID controller of the deviation e, with its integral part s and the state d of the filter of its
/// derivative:
///
///     v = k_p e + s + k_d (e − d)/T_d,   T_d ḋ = e − d,   ṡ = k_i e
///
/// Åström & Hägglund, Advanced PID Control (2006), sections 3.2 and 3.5.
template <class Self, auto... given>
struct pid_law {
  template <std::size_t index>
  static constexpr auto argument = argument_or_zero<index, given...>();

  static constexpr state_variable_of<"s", Self> integral_part{};
  static constexpr state_variable_of<"d", Self> filtered{};
  static constexpr auto deviation = argument<0>;
  static constexpr auto unlimited =
      argument<1> * deviation + integral_part + argument<3> * ((deviation - filtered) / argument<4>);
  static constexpr bool is_limited = sizeof...(given) > 5;

  /// The output v kept between limits, rounded over a hundredth of the range.
  static constexpr auto limited_output() {
    if constexpr (is_limited) {
      constexpr auto width = 0.01 * (argument<6> - argument<5>);
      return argument<5> + softplus(unlimited - argument<5>, width) -
             softplus(unlimited - argument<6>, width);
    } else {
      return unlimited;
    }
  }
  static constexpr auto rate_of_integral_part() {
    if constexpr (is_limited)
      return argument<2> * deviation + (limited_output() - unlimited) / argument<7>;
    else
      return argument<2> * deviation;
  }

  static constexpr block_record record() {
    return states_of_block<Self, integral_part, filtered>::template with < dot(integral_part) ==
               rate_of_integral_part(),
           argument<4> * dot(filtered) ==
               deviation - filtered >
                   (sizeof...(given) <= 5
                        ? arguments_of("pid<Self, deviation, kp, ki, kd, Td>", sizeof...(given), 5)
                        : arguments_of("pid<Self, deviation, kp, ki, kd, Td, least, greatest, Tt>",
                                       sizeof...(given), 8));
  }
};

} // namespace describe

/// A PID controller of a deviation e, with a filtered derivative: `struct C : pid<C, e, kp, ki, kd, Td> {}`.
/// `C::output` is kp e + s + kd (e − d)/Td, with the state variables s_C and d_C, where ṡ = ki e and
/// Td ḋ = e − d.
///
/// With limits, `pid<C, e, kp, ki, kd, Td, least, greatest, Tt>`, the output stays between them, rounded over
/// a hundredth of their distance, and the integral part returns from them with the time constant Tt
/// (anti-windup by back-calculation). To limit its rate, pass the output to `slew_limit`. The output depends
/// on e without delay, so e must not contain anything that the output determines except through rates.
template <class Self, auto... deviation_gains_and_limits>
struct pid : describe::block_words {
private:
  using law = describe::pid_law<Self, deviation_gains_and_limits...>;

public:
  static constexpr auto output = law::limited_output();
  static constexpr describe::block_record block = law::record();
};

} // namespace kanexpr
