#pragma once

#include <kanexpr/describe/blocks/block.hpp>

namespace kanexpr {

/// A first-order lag, T ẏ = x − y: `struct Filter : lag<Filter, x, T> {}`. `Filter::output` is y, the state
/// variable y_Filter.
template <class Self, auto... input_and_time>
struct lag : describe::block_words {
  static constexpr describe::state_variable_of<"y", Self> output{};

  static constexpr auto time = describe::argument_or_zero<1, input_and_time...>();
  static constexpr describe::block_record block =
      describe::requiring<describe::positive_of<"the time constant of ", time>>(
          describe::states_of_block<Self, output>::template with < time * dot(output) ==
          describe::argument_or_zero<0, input_and_time...>() - output >
              (describe::arguments_of("lag<Self, input, time>", sizeof...(input_and_time), 2)));
};

namespace describe {

/// r tanh((x − y)/(r T)), which is (x − y)/T where that is small compared with r.
template <class Input, class Output, class Rate, class Time>
constexpr auto limited_rate(const Input& x, const Output& y, const Rate& rate, const Time& time) {
  const auto deviation = x - y;
  return rate * tanh(deviation / (rate * time));
}

} // namespace describe

/// Follows an input with a limited rate, ẏ = r tanh((x − y)/(r T)): a lag of the time T whose rate is less
/// than r: `struct Valve : slew_limit<Valve, x, r, T> {}`. The limit is smooth. `Valve::output` is y.
template <class Self, auto... input_rate_and_time>
struct slew_limit : describe::block_words {
  static constexpr describe::state_variable_of<"y", Self> output{};

  static constexpr auto rate = describe::argument_or_zero<1, input_rate_and_time...>();
  static constexpr auto time = describe::argument_or_zero<2, input_rate_and_time...>();
  static constexpr describe::block_record block = describe::requiring<
      describe::positive_of<"the rate of ", rate>, describe::positive_of<"the time constant of ", time>>(
      describe::states_of_block<Self, output>::template with < dot(output) ==
      describe::limited_rate(describe::argument_or_zero<0, input_rate_and_time...>(), output, rate, time) >
          (describe::arguments_of("slew_limit<Self, input, rate, time>", sizeof...(input_rate_and_time), 3)));
};

} // namespace kanexpr
