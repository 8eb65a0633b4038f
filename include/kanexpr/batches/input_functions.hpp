#pragma once

#include <kanexpr/batches/batch.hpp>
#include <kanexpr/batches/many.hpp>

#include <type_traits>

namespace kanexpr::batches {

namespace detail {

template <class State, class Law, class Result, class Time, class Given>
constexpr bool takes(Result (Law::*)(Time, Given) const) {
  return std::is_same_v<std::remove_cvref_t<Given>, State>;
}
template <class State, class Law, class Result, class Time, class Given>
constexpr bool takes(Result (Law::*)(Time, Given) const noexcept) {
  return std::is_same_v<std::remove_cvref_t<Given>, State>;
}
template <class State>
constexpr bool takes(...) {
  return false;
}

} // namespace detail

/// Whether an input function (t, x) takes the states of a batch. A function that specifies the type of x
/// takes only that type; a generic one takes any.
template <class Law, class State>
constexpr bool accepts_batch() {
  if constexpr (requires { &Law::operator(); })
    return detail::takes<State>(&Law::operator());
  else
    return std::is_class_v<Law>;
}

/// Whether an argument can serve as inputs: the inputs of one system or of many, no inputs, or a function (t,
/// x).
template <class Given, class State, class Batch>
inline constexpr bool is_input_argument = [] {
  if constexpr (requires { Given::SizeAtCompileTime; } || is_many<Given> ||
                std::is_same_v<Given, compiled::omitted>)
    return true;
  else if constexpr (accepts_batch<Given, with_scalar<State, typename Batch::number>>())
    return std::is_invocable_v<const Given&, double, const with_scalar<State, typename Batch::number>&>;
  else
    return std::is_invocable_v<const Given&, double, const State&>;
}();

/// Calls a function of one state for each lane.
template <class Batch, class Inputs, class Law>
struct per_lane_inputs {
  const Law& law;

  template <class Time, class State>
  auto operator()(const Time& t, const State& x) const {
    with_scalar<Inputs, typename Batch::number> all;
    for (std::size_t lane = 0; lane < Batch::lanes; ++lane)
      Batch::set(all, lane, law(t, Batch::get(x, lane)));
    return all;
  }
};

} // namespace kanexpr::batches
