// A cart balances a pendulum with a controller that runs two hundred times a second: a Kalman filter
// estimates its state from noisy sensors, and a regulator computed by the compiler determines the force. The
// same controller runs on a microcontroller.
#include "output.hpp"
#include "print.hpp"

#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/balanced_cart.hpp>
#include <pictures/n_pendulum_cart.hpp>

#include <cmath>
#include <cstdio>

int main(int count, char** words) {
  using namespace balanced_cart;
  const output files("A cart that feels its way",
                     "Sensors with noise tell where it is and how the pendulum stands.", count, words);
  const state<cart> start(-0.5, upright + 0.2, 0, 0), guess(-0.4, upright + 0.1, 0, 0);

  loop<double> moving(start, guess);
  trajectory<cart> path(parameters_in<double>());
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  for (int k = 0; k < 200 * 8; ++k) {
    if (const status s = moving.go_on(); !s) return std::fprintf(stderr, "%s\n", s.cause().c_str()), 1;
    path.add({moving.t, moving.x, moving.control.force});
    if (moving.t > 1) squares += (moving.control.estimate.x - moving.x).cwiseAbs2() / (200 * 7);
  }

  print("gain", numeric::as_eigen(regulator.K));
  for (const double t : {1.0, 2.0, 4.0, 8.0})
    std::printf("after %g s: cart at %6.3f m, pendulum %6.3f rad off\n", t, path.at(t)->x[q<0>],
                path.at(t)->x[q<1>] - upright);
  print("the estimate is off by", squares.cwiseSqrt());
  print("and takes itself to be", moving.control.estimate.P.diagonal().cwiseSqrt());
  return files.leave<n_pendulum_cart::picture>(path) ? 0 : 1;
}
