// A torus that rolls without slipping: its contact wanders over a round tube.
#include "report.hpp"

#include <models/rolling_torus.hpp>

int main() {
  using namespace rolling_torus;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.833841;
  x[q3] = 1.582648;
  x[u1] = -1.959448;
  x[u2] = -0.036519;
  x[u3] = -0.404071;

  eom::parameters p;
  p[R] = 0.5;
  p[a] = 0.12;
  p[m] = 3.1;
  p[g] = 9.81;

  report check("rolling_torus", 1e-12);
  check("udot", eom::udot(x, p),
        Eigen::Vector3d{7.887663813136363, -0.38048561935797964, 0.8464989362272266});
  check("kinetic energy", eom::kinetic_energy(x, p), 2.8856396620114135);
  check("potential energy", eom::potential_energy(x, p), 13.86796939405356);
  return check.exit_code();
}
