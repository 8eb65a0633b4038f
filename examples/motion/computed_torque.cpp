// A seven-joint arm follows a motion although it starts away from it. A thousand times a second, the torques
// are computed by the compiled equations from the desired accelerations. The same controller runs on a
// microcontroller.
#include "output.hpp"

#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/computed_torque.hpp>
#include <pictures/iiwa.hpp>

#include <cmath>
#include <cstdio>

int main(int count, char** words) {
  using namespace computed_torque;
  const output files("An arm that finds its path",
                     "Every joint begins beside the motion that it is to follow.", count, words);
  joints<double> beside;
  beside << -0.2, 0.2, -0.2, 0.2, -0.2, 0.2, -0.2;
  state<System> start;
  start.q() = numeric::as_eigen(begin) + beside;

  loop<double> moving(start);
  trajectory<System> path;
  for (int k = 1; k <= 2500; ++k) {
    if (const status s = moving.go_on(); !s) return std::fprintf(stderr, "%s\n", s.cause().c_str()), 1;
    path.add({moving.t, moving.x, moving.r});
    if (k % 250 == 0)
      std::printf("after %4.2f s: %.6f rad off; by the gains %.6f\n", moving.t,
                  moving.error().cwiseAbs().maxCoeff(), 0.2 * (1 + 10 * moving.t) * std::exp(-10 * moving.t));
  }
  return files.leave<iiwa::picture>(path) ? 0 : 1;
}
