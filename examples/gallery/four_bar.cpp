// A motor turns the crank of a four-bar linkage.
#include <motion/four_bar.hpp>
#include <parts/page.hpp>
#include <pictures/four_bar.hpp>

int main(int count, char** words) {
  using namespace four_bar;
  gallery::page page(count, words,
                     {.title = "Four-bar linkage",
                      .kind = "Mechanisms",
                      .see = "The crank goes around, and the rocker swings back and forth. The middle of the "
                             "coupler draws a coupler curve, "
                             "the means by which designers choose such linkages.",
                      .source = "Hrones & Nelson, Analysis of the Four-Bar Linkage (1951); Norton, Design of "
                                "Machinery (2019), chapter 3"});
  const double torque = 2; // N m
  const auto run = turned_by_motor(torque);
  const auto energies = run.trajectory.energies();
  std::vector<double> kept = energies.total;
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] -= torque * run.trajectory[i].x[q1];
  page.expect_constant("the energy without the work of the motor", kept,
                       *std::max_element(energies.kinetic.begin(), energies.kinetic.end()), 1e-7);
  page.expect_constraints(run.trajectory, 1e-9);
  page.expect(run.state[q1] > 6.3, "the crank turns all the way around");
  return page.show<four_bar::picture>(run, {.at = 0.1});
}
