// A motor turns a four-bar linkage, whose loop stays closed.
#include "output.hpp"
#include "report.hpp"

#include <kanexpr/simulate.hpp>
#include <pictures/four_bar.hpp>

#include <algorithm>
#include <cmath>
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
  report check("four_bar_motion", 0);
  const auto energy = path.energies().total;
  double largest_loss = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double work = torque_of_motor * (path[i].x[q1] - path[0].x[q1]);
    largest_loss = std::max(largest_loss, std::abs(energy[i] - energy[0] - work));
  }
  const double turns = (run.state[q1] - path[0].x[q1]) / (2 * std::numbers::pi);
  std::printf("  the crank turned %.2f times; %ld steps\n", turns, run.statistics.steps);
  check.at_most("work that is not in the energy", largest_loss, 1e-7 * (energy.back() - energy[0]));
  check.at_most("what the loop leaves open", std::ranges::max(path.constraint_residuals()), 1e-10);
  return files.leave<four_bar::picture>(path) ? check.exit_code() : 1;
}
