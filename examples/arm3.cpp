// A spatial arm with three links; all quantities are parameters.
#include "print.hpp"

#include <models/arm3.hpp>

int main() {
  using namespace arm3;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q<1>] = -2.193815;
  x[q<2>] = 2.084602;
  x[q<3>] = 1.582648;
  x[u<1>] = -1.469586;
  x[u<2>] = -0.027389;
  x[u<3>] = -0.303054;

  eom::parameters p;
  p[g] = 9.81;
  p[m<1>] = 1.116;
  p[cx<1>] = -0.106;
  p[cy<1>] = -0.209;
  p[cz<1>] = 0.091;
  p[Ixx<1>] = 0.0491;
  p[Iyy<1>] = 0.0642;
  p[Izz<1>] = 0.0533;
  p[Ixy<1>] = -0.0052;
  p[Iyz<1>] = -0.0049;
  p[Izx<1>] = -0.0009;
  p[lx<1>] = -0.428;
  p[ly<1>] = 0.036;
  p[lz<1>] = -0.134;
  p[m<2>] = 1.793;
  p[cx<2>] = 0.196;
  p[cy<2>] = -0.226;
  p[cz<2>] = -0.166;
  p[Ixx<2>] = 0.0622;
  p[Iyy<2>] = 0.0911;
  p[Izz<2>] = 0.0677;
  p[Ixy<2>] = -0.0025;
  p[Iyz<2>] = -0.0043;
  p[Izx<2>] = -0.0046;
  p[lx<2>] = 0.127;
  p[ly<2>] = 0.448;
  p[lz<2>] = 0.077;
  p[m<3>] = 2.095;
  p[cx<3>] = -0.115;
  p[cy<3>] = 0.19;
  p[cz<3>] = -0.192;
  p[Ixx<3>] = 0.043;
  p[Iyy<3>] = 0.0441;
  p[Izz<3>] = 0.0407;
  p[Ixy<3>] = 0.0022;
  p[Iyz<3>] = -0.0009;
  p[Izx<3>] = -0.0022;

  eom::inputs inputs;
  inputs[T<1>] = 3.031859;
  inputs[T<2>] = 5.774467;
  inputs[T<3>] = -8.122808;

  print("mass matrix", eom::mass_matrix(x, p));
  print("forcing", eom::forcing(x, p, inputs));
  print("udot", eom::udot(x, p, inputs));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
