#pragma once

#include "call.hpp"

#include <kanexpr/fixed_step.hpp>

namespace embedded {

/// A step of a system by the Runge-Kutta method, and whether it could be made, at some calls of it.
template <class Calls>
struct step_of : Calls {
  using system = typename Calls::system;
  static constexpr std::size_t found = arguments<system, double>::size_of_x + 1;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const arguments<system, T> at(given);
    kanexpr::state<system, T> x(at.x);
    T t = 0;
    const kanexpr::status made = kanexpr::runge_kutta_4<system>{}(t, x, T(0.001), at.p, at.r);
    *put(found, x) = as_number<T>(made);
  }
};

} // namespace embedded
