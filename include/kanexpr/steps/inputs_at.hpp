#pragma once

#include <kanexpr/compiled/state.hpp>

#include <type_traits>

namespace kanexpr::steps {

/// Whether the inputs are a vector, which is held constant during a step, or omitted, rather than a function.
template <class Inputs>
inline constexpr bool inputs_hold =
    requires { Inputs::SizeAtCompileTime; } || std::is_same_v<Inputs, compiled::not_given>;

/// Returns the inputs at an instant, from a vector or a function.
template <class Inputs, class Time, class State>
[[gnu::always_inline]] inline decltype(auto) inputs_at(const Inputs& r, const Time& t, const State& x) {
  if constexpr (inputs_hold<Inputs>)
    return (r);
  else
    return r(t, x);
}

} // namespace kanexpr::steps
