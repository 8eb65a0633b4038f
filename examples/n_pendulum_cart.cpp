// A chain of five pendulums on a cart; the number of pendulums is a template argument of the model.
#include "print.hpp"

#include <models/n_pendulum_cart.hpp>

int main() {
  using namespace n_pendulum_cart;
  using eom = kanexpr::equations_of_motion<System<5>>;

  eom::state x;
  x[q<0>] = -1.462543;
  x[q<1>] = 2.182991;
  x[q<2>] = 1.657345;
  x[q<3>] = -1.538947;
  x[q<4>] = -0.028682;
  x[q<5>] = -0.317357;
  x[u<0>] = 0.909558;
  x[u<1>] = 1.73234;
  x[u<2>] = -2.436842;
  x[u<3>] = -2.829915;
  x[u<4>] = 2.014591;
  x[u<5>] = -0.403398;

  eom::parameters p;
  p[m<0>] = 2.0;
  p[m<1>] = 0.9;
  p[m<2>] = 0.8;
  p[m<3>] = 0.7;
  p[m<4>] = 0.6;
  p[m<5>] = 0.5;
  p[l<0>] = 0.8;
  p[l<1>] = 0.7;
  p[l<2>] = 0.6;
  p[l<3>] = 0.5;
  p[l<4>] = 0.4;
  p[g] = 9.81;

  eom::inputs inputs;
  inputs[F] = 10.491203;

  print("mass matrix", eom::mass_matrix(x, p));
  print("forcing", eom::forcing(x, p, inputs));
  print("udot", eom::udot(x, p, inputs));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
