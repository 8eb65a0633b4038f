// A motor turns a four-bar linkage, whose loop stays closed.
#include "output.hpp"

#include <kanexpr/simulate.hpp>
#include <pictures/four_bar.hpp>

#include <algorithm>
#include <cstdio>
#include <numbers>

int main(int count, char** words) {
  using namespace four_bar;
  const output files("A four-bar linkage", "A motor turns the crank with a constant torque.", count, words);
  const double torque_of_motor = 1.5;

  // The crank is where it is; the other angles need only be near.
  const auto run = simulate<System>({{q1, 0.5}, {q2, 0.4}, {q3, -2}, {u1, 7}},
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
                                    {.inputs = {{T, torque_of_motor}},
                                     .relative_tolerance = 1e-10,
                                     .absolute_tolerance = 1e-12,
                                     .output_every = 0.01});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;
  const auto& path = run.trajectory;

  // What the motor does goes into the energy.
  const double angle = run.state[q1] - path[0].x[q1];
  const auto energy = path.energies().total;
  std::printf("the crank turned %.2f times in %ld steps\n", angle / (2 * std::numbers::pi),
              run.statistics.steps);
  std::printf("work of the motor %.6f J, energy gained %.6f J\n", torque_of_motor * angle,
              energy.back() - energy[0]);
  std::printf("the loop is open by %.1e m at most\n", std::ranges::max(path.constraint_residuals()));
  return files.leave<four_bar::picture>(path) ? 0 : 1;
}
