#pragma once

#include "pendulum.hpp"

#include <kanexpr/fixed_step.hpp>

/// A step of the pendulum by the Runge-Kutta method, and whether it could be made.
struct program : embedded::pendulum::calls {
  using system = embedded::pendulum::System;
  static constexpr std::size_t found = embedded::arguments<system, double>::size_of_x + 1;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    kanexpr::state<system, T> x(at.x);
    T t = 0;
    const kanexpr::status made = kanexpr::runge_kutta_4<system>{}(t, x, T(0.001), at.p, at.r);
    *embedded::put(found, x) = embedded::as_number<T>(made);
  }
};
