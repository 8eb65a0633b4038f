#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/composed.hpp>

namespace kanexpr {

namespace describe {

/// The output v = k_p e + s + k_d (e − d)/T_d of a PID controller without limits.
template <class Deviation, class Integral, class Filtered, class Kp, class Kd, class Time>
constexpr auto unlimited_output(const Deviation& e, const Integral& s, const Filtered& d, const Kp& kp,
                                const Kd& kd, const Time& Td) {
  const auto proportional = kp * e;
  const auto derivative = kd * ((e - d) / Td);
  return proportional + s + derivative;
}
/// An output kept between limits, rounded over a hundredth of the range.
template <class Output, class Least, class Greatest>
constexpr auto limited_output(const Output& v, const Least& least, const Greatest& greatest) {
  const auto width = 0.01 * (greatest - least);
  const auto above_least = softplus(v - least, width);
  const auto above_greatest = softplus(v - greatest, width);
  return least + above_least - above_greatest;
}
/// ṡ of a limited output, which returns from the limits with the time constant Tt.
template <class Deviation, class Ki, class Limited, class Output, class Time>
constexpr auto rate_of_integral_part(const Deviation& e, const Ki& ki, const Limited& limited,
                                     const Output& v, const Time& Tt) {
  const auto integrated = ki * e;
  const auto returning = (limited - v) / Tt;
  return integrated + returning;
}

/// A PID controller of the deviation e, with its integral part s and the state d of the filter of its
/// derivative:
///
///     v = k_p e + s + k_d (e − d)/T_d,   T_d ḋ = e − d,   ṡ = k_i e
///
/// A PI controller has neither a derivative nor a filter. Åström & Hägglund, Advanced PID Control (2006),
/// sections 3.2 and 3.5.
template <class Self, auto... given>
struct pid_law {
  template <std::size_t index>
  static constexpr auto argument = argument_or_zero<index, given...>();

  static constexpr std::size_t size = sizeof...(given);
  static constexpr bool has_derivative = size != 3 && size != 6, is_limited = size > 5;
  static constexpr std::size_t least = has_derivative ? 5 : 3; // the index of the first limit

  static constexpr state_variable_of<"s", Self> integral_part{};
  static constexpr state_variable_of<"d", Self> filtered{};
  static constexpr auto deviation = argument<0>;

  static constexpr auto unlimited() {
    if constexpr (has_derivative)
      return unlimited_output(deviation, integral_part, filtered, argument<1>, argument<3>, argument<4>);
    else
      return argument<1> * deviation + integral_part;
  }
  static constexpr auto output() {
    if constexpr (is_limited)
      return limited_output(unlimited(), argument<least>, argument<least + 1>);
    else
      return unlimited();
  }
  static constexpr auto integral_rate() {
    if constexpr (is_limited)
      return rate_of_integral_part(deviation, argument<2>, output(), unlimited(), argument<least + 2>);
    else
      return argument<2> * deviation;
  }

  static constexpr arguments fits() {
    if (size <= 3) return arguments_of("pid<Self, deviation, kp, ki>", size, 3);
    if (size <= 5) return arguments_of("pid<Self, deviation, kp, ki, kd, Td>", size, 5);
    if (size == 6) return arguments_of("pid<Self, deviation, kp, ki, least, greatest, Tt>", size, 6);
    return arguments_of("pid<Self, deviation, kp, ki, kd, Td, least, greatest, Tt>", size, 8);
  }
  static constexpr auto integration = dot(integral_part) == integral_rate();
  template <const positive_argument&... others>
  static constexpr block_record limited(const block_record& r) {
    if constexpr (is_limited)
      return requiring<
          positive_of<"the time constant of the integral part of ", argument<least + 2>>,
          positive_of<"the distance between the limits of ", argument<least + 1> - argument<least>>,
          others...>(r);
    else
      return requiring<others...>(r);
  }
  static constexpr block_record record() {
    if constexpr (has_derivative)
      return limited<positive_of<"the time constant of the filter of ", argument<4>>>(
          states_of_block<Self, integral_part, filtered>::template with < integration,
          argument<4> * dot(filtered) == deviation - filtered > (fits()));
    else
      return limited<>(states_of_block<Self, integral_part>::template with<integration>(fits()));
  }
};

} // namespace describe

/// A PID controller of a deviation e, with a filtered derivative: `struct C : pid<C, e, kp, ki, kd, Td> {}`.
/// `C::output` is kp e + s + kd (e − d)/Td, with the state variables s_C and d_C, where ṡ = ki e and
/// Td ḋ = e − d.
///
/// With limits, `pid<C, e, kp, ki, kd, Td, least, greatest, Tt>`, the output stays between them, rounded over
/// a hundredth of their distance, and the integral part returns from them with the time constant Tt
/// (anti-windup by back-calculation). Without kd and Td, `pid<C, e, kp, ki>` and `pid<C, e, kp, ki, least,
/// greatest, Tt>` are PI controllers, which have only the state variable s_C. To limit its rate, pass the
/// output to `slew_limit`. The output depends on e without delay, so e must not contain anything that the
/// output determines except through rates.
template <class Self, auto... deviation_gains_and_limits>
struct pid : describe::block_words {
private:
  using law = describe::pid_law<Self, deviation_gains_and_limits...>;

public:
  static constexpr auto output = law::output();
  static constexpr describe::block_record block = law::record();
};

} // namespace kanexpr
