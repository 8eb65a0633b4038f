// A body on a spherical joint; kanexpr provides the kinematic equations of its quaternion.
#include "print.hpp"

#include <models/pivot_body.hpp>

int main() {
  using namespace pivot_body;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[e0] = -0.40630026186307056;
  x[e1] = -0.39572570684672104;
  x[e2] = 0.23073953305457698;
  x[e3] = -0.790620345068617;
  x[u1] = 1.919189;
  x[u2] = 3.3786;
  x[u3] = -3.767958;

  eom::parameters p;
  p[m] = 1.4;
  p[Ixx] = 0.05;
  p[Iyy] = 0.07;
  p[Izz] = 0.06;
  p[Ixy] = 0.008;
  p[g] = 9.81;
  p[a] = 0.1;
  p[b] = -0.05;
  p[c] = 0.2;

  const eom::inputs r{{-0.137509, 1.773427, 0.595898}};

  print("qdot", eom::qdot(x, p, r));
  print("udot", eom::udot(x, p, r));
  print("kinetic energy", eom::kinetic_energy(x, p, r));
  print("potential energy", eom::potential_energy(x, p, r));
}
