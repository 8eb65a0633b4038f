// Two bars with friction and a motor in each joint.
#include "report.hpp"

#include <models/double_pendulum.hpp>

int main() {
  using namespace double_pendulum;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.297357;
  x[q2] = 2.182991;
  x[u1] = 2.110197;
  x[u2] = -1.959448;

  eom::parameters p;
  p[m1] = 1.1;
  p[m2] = 0.6;
  p[d1] = 0.4;
  p[d2] = 0.35;
  p[l1] = 0.9;
  p[I1] = 0.07;
  p[I2] = 0.02;
  p[g] = 9.81;
  p[c1] = 0.03;
  p[c2] = 0.02;

  eom::inputs inputs;
  inputs[T1] = -0.027389;
  inputs[T2] = -0.303054;

  report check("double_pendulum", 1e-12);
  check("mass matrix", eom::mass_matrix(x, p),
        Eigen::Matrix2d{{0.7320000000000001, -0.10861167338885658},
                        {-0.10861167338885658, 0.09349999999999999}});
  check("forcing", eom::forcing(x, p, inputs), Eigen::Vector2d{7.111307107100544, -2.957062457500641});
  check("udot", eom::udot(x, p, inputs), Eigen::Vector2d{6.068190517641627, -24.577391774729332});
  check("kinetic energy", eom::kinetic_energy(x, p), 2.2583563989761926);
  check("potential energy", eom::potential_energy(x, p), -7.421057428191635);
  return check.exit_code();
}
