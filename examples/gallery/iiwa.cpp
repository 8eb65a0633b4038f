// An arm of seven joints follows a motion on which it does not begin.
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/computed_torque.hpp>
#include <parts/page.hpp>
#include <pictures/iiwa.hpp>

int main(int count, char** words) {
  using namespace computed_torque;
  gallery::page page(count, words,
                     {.title = "Arm with computed torques",
                      .kind = "Control",
                      .see = "The arm starts 0.2 rad beside the planned motion in every joint, joins it "
                             "within half a second and follows it exactly. The "
                             "torques are those that the compiled equations require for the wanted "
                             "accelerations, a thousand times a second.",
                      .source = "Siciliano, Sciavicco, Villani & Oriolo, Robotics: Modelling, Planning and "
                                "Control (2009), section 8.5"});
  joints<double> beside;
  beside << -0.2, 0.2, -0.2, 0.2, -0.2, 0.2, -0.2;
  state<System> start;
  start.q() = numeric::as_eigen(begin) + beside;
  loop<double> moving(start);
  trajectory<System> path;
  double worst = 0;
  for (int k = 1; k <= 2500; ++k) {
    if (const status s = moving.go_on(); !s) page.refuse(s.cause());
    if (k % 20 == 0) path.add({moving.t, moving.x, moving.r});
    // The error of a second-order system with a double pole at −10/s.
    worst = std::max(worst, moving.error().cwiseAbs().maxCoeff() -
                                0.2 * (1 + 10 * moving.t) * std::exp(-10 * moving.t));
  }
  page.expect_small("the error decays as (1 + 10 t) exp(−10 t)", worst, 2e-3);
  page.expect(moving.error().cwiseAbs().maxCoeff() < 1e-4, "the arm reaches the end of the motion");
  return page.show<iiwa::picture>(path, {.lengths = false});
}
