#pragma once

#include <kanexpr/simulate.hpp>
#include <models/four_bar.hpp>

namespace four_bar {

/// Three seconds of a linkage whose crank is driven by a constant torque.
inline simulation<System> turned_by_motor(double torque) {
  // The angle of the crank is given; the other angles need only be approximate.
  return simulate<System>({{q1, 0.5}, {q2, 0.4}, {q3, -2}, {u1, 7}},
                          {{l0, 1.0},
                           {l1, 0.4},
                           {l2, 1.1},
                           {l3, 0.8},
                           {d1, 0.15},
                           {d2, 0.6},
                           {d3, 0.35},
                           {m1, 0.5},
                           {m2, 1.2},
                           {m3, 0.9},
                           {I1, 0.011},
                           {I2, 0.13},
                           {I3, 0.05},
                           {g, 9.81}},
                          {0, 3},
                          {.inputs = {{T, torque}},
                           .guesses_dependent = true,
                           .relative_tolerance = 1e-10,
                           .absolute_tolerance = 1e-12,
                           .output_every = 0.01});
}

} // namespace four_bar
