#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>

/// Motions to more digits than double has, to compare with.
namespace reference {

using real = long double;

template <class Motion>
using state = kanexpr::state<typename Motion::System, real>;

template <class Motion>
state<Motion> rates(real t, const state<Motion>& x) {
  using System = typename Motion::System;
  kanexpr::input_values<System> r;
  r.setZero();
  Motion::give_inputs(static_cast<double>(t), kanexpr::state<System>(x.template cast<double>()), r);
  const auto rate = kanexpr::equations_of_motion<System>::rhs(t, x, Motion::parameters(), r);
  if (!kanexpr::status_of(rate)) std::exit(1);
  state<Motion> out;
  out = rate;
  return out;
}

/// The state at the end of the motion, by extrapolated midpoint rules (Gragg 1965) of order 16.
template <class Motion>
kanexpr::state<typename Motion::System> end_of(const kanexpr::state<typename Motion::System>& start,
                                               int steps) {
  constexpr std::size_t rows = 8;
  const real length = (real(Motion::span.to) - real(Motion::span.from)) / steps;
  state<Motion> x;
  x = start.template cast<real>();
  for (int step = 0; step < steps; ++step) {
    const real t = real(Motion::span.from) + step * length;
    std::array<state<Motion>, rows> table;
    for (std::size_t row = 0; row < rows; ++row) {
      const int parts = 2 * static_cast<int>(row + 1);
      const real h = length / parts;
      state<Motion> before = x, now = x;
      now += h * rates<Motion>(t, x);
      for (int i = 1; i < parts; ++i) {
        const state<Motion> last = now;
        now = before;
        now += 2 * h * rates<Motion>(t + i * h, last);
        before = last;
      }
      state<Motion> better = now;
      better += before + h * rates<Motion>(t + length, now);
      better /= 2;
      for (std::size_t column = 1; column <= row; ++column) { // Neville's scheme in h²
        const real ratio = real(row + 1) / real(row + 1 - column);
        const state<Motion> coarser = table[column - 1];
        table[column - 1] = better;
        better += (better - coarser) / (ratio * ratio - 1);
      }
      table[row] = better;
    }
    x = table[rows - 1];
  }
  return kanexpr::state<typename Motion::System>(x.template cast<double>());
}

} // namespace reference
