// A disc that rolls without slipping: the speeds satisfy the constraint by themselves.
#include "report.hpp"

#include <models/rolling_disc.hpp>

int main() {
  using namespace rolling_disc;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.833841;
  x[q3] = 1.582648;
  x[u1] = -1.959448;
  x[u2] = -0.036519;
  x[u3] = -0.404071;

  eom::parameters p;
  p[r] = 0.45;
  p[m] = 2.2;
  p[g] = 9.81;

  report check("rolling_disc", 1e-12);
  check("mass matrix", eom::mass_matrix(x, p),
        Eigen::Matrix3d{
            {0.5568750000000001, 0.0, 0.0}, {0.0, 0.6682500000000001, 0.0}, {0.0, 0.0, 0.11137500000000002}});
  check("forcing", eom::forcing(x, p),
        Eigen::Vector3d{7.181661184668668, -0.3527273482559641, 0.08122838593422786});
  check("udot", eom::udot(x, p),
        Eigen::Vector3d{12.896361274376956, -0.5278374085386667, 0.7293233304981176});
  check("kinetic energy", eom::kinetic_energy(x, p), 1.078580978185485);
  return check.exit_code();
}
