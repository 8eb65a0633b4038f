// A motor drives a four-bar linkage, whose loop stays closed.
#include "output.hpp"

#include <motion/four_bar.hpp>
#include <pictures/four_bar.hpp>

#include <algorithm>
#include <cstdio>
#include <numbers>

int main(int count, char** words) {
  using namespace four_bar;
  const output files("A four-bar linkage", "A motor turns the crank with a constant torque.", count, words);
  const double torque_of_motor = 1.5;

  const auto run = turned_by_motor(torque_of_motor);
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;
  const auto& path = run.trajectory;

  // The work of the motor increases the energy.
  const double angle = run.state[q1] - path[0].x[q1];
  const auto energy = path.energies().total;
  std::printf("the crank turned %.2f times in %ld steps\n", angle / (2 * std::numbers::pi),
              run.statistics.steps);
  std::printf("work of the motor %.6f J, energy gained %.6f J\n", torque_of_motor * angle,
              energy.back() - energy[0]);
  std::printf("the loop is open by %.1e m at most\n", std::ranges::max(path.constraint_residuals()));
  return files.leave<four_bar::picture>(path) ? 0 : 1;
}
