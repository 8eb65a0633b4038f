// A bicycle is pushed to the side and slows down to a speed at which it would fall on its own. The torque at
// its fork, with gains that the compiler computed for each speed, keeps it upright. The same controller runs
// on a microcontroller.
#include "output.hpp"

#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/balanced_bicycle.hpp>
#include <pictures/bicycle.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main(int count, char** words) {
  using namespace balanced_bicycle;
  const output files("A bicycle at walking pace", "The fork is turned so that it does not fall.", count,
                     words);

  loop<double> riding(0.4);
  trajectory<Driven> path;
  double most = 0;
  for (int k = 1; k <= 1200; ++k) {
    if (const status s = riding.go_on(); !s) return std::fprintf(stderr, "%s\n", s.cause().c_str()), 1;
    path.add({riding.t, riding.x, riding.r});
    most = std::max(most, std::abs(riding.x[q2]));
    if (k % 200 != 0) continue;
    std::printf("%2.0f s: at %.2f m/s it leaned %.3f rad at most\n", riding.t, rear_radius * riding.x[u3],
                most);
    most = 0;
  }

  for (const double v : {2.0, 4.0, 6.0})
    std::printf("gains at %g m/s: %7.2f %6.2f %7.2f %5.2f\n", v, gains(v)(0, 0), gains(v)(0, 1),
                gains(v)(0, 2), gains(v)(0, 3));

  state<Driven> free;
  free[u2] = 0.1, free[u3] = 3 / rear_radius, free[u6] = 3 / front_radius;
  double t = 0;
  while (std::abs(free[q2]) < 0.7 && t < 20) // at 0.65 the handlebars are at right angles
    if (const status s = passing<runge_kutta_4<Driven>>{}(t, free, period, parameter_values<Driven>(),
                                                          input_values<Driven>(0, 0));
        !s)
      return std::fprintf(stderr, "%s\n", s.cause().c_str()), 1;
  std::printf("without a torque it falls at 3 m/s within %.1f s\n", t);
  return files.leave<picture_of<Driven>>(path) ? 0 : 1;
}
