// A spinning top; its speeds are not rates of its angles.
#include "report.hpp"

#include <models/spinning_top.hpp>

int main() {
  using namespace spinning_top;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 2.418584;
  x[q3] = 1.582648;
  x[u1] = -2.44931;
  x[u2] = -0.045649;
  x[u3] = -6.061072;

  eom::parameters p;
  p[m] = 0.5;
  p[l] = 0.08;
  p[g] = 9.81;
  p[A] = 0.0009;
  p[C] = 0.0006;

  report check("spinning_top", 1e-12);
  check("mass matrix", eom::mass_matrix(x, p),
        Eigen::Matrix3d{{0.0041, 0.0, 0.0}, {0.0, 0.0041, 0.0}, {0.0, 0.0, 0.0006}});
  check("forcing", eom::forcing(x, p), Eigen::Vector3d{0.25945326004004543, 0.009426772945867449, 0.0});
  check("udot", eom::udot(x, p), Eigen::Vector3d{63.28128293659644, 2.299212913626207, 0.0});
  check("kinetic energy", eom::kinetic_energy(x, p), 0.023323444916722252);
  check("potential energy", eom::potential_energy(x, p), -0.2942287673943947);
  return check.exit_code();
}
