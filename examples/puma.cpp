// The Puma 560 with numeric values; the reference is RBDL.
#include "print.hpp"

#include <models/puma.hpp>

int main() {
  using namespace puma;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q<1>] = 1.5983500054156474;
  x[q<2>] = 2.8230427165131764;
  x[q<3>] = -2.403856968140654;
  x[q<4>] = 2.462463113609908;
  x[q<5>] = -2.253957243345467;
  x[q<6>] = -2.795432129551702;
  x[u<1>] = 1.3300919221257832;
  x[u<2>] = 0.8716227385960136;
  x[u<3>] = -0.4102181823370643;
  x[u<4>] = -0.7839793422967312;
  x[u<5>] = 1.466170043740405;
  x[u<6>] = -0.8307220415639975;
  eom::inputs torque;
  torque[T<1>] = -4.85683862472006;
  torque[T<2>] = 1.9237756155686636;
  torque[T<3>] = 6.643367447514999;
  torque[T<4>] = 9.8730545642556;
  torque[T<5>] = 2.4112315114570393;
  torque[T<6>] = -9.331034086428673;

  // All results in one call, because they share subexpressions.
  const eom::parameters none; // the numbers are part of the type
  const auto [M, f, udot] = eom::together(eom::mass_matrix, eom::forcing, eom::udot)(x, none, torque);

  print("mass matrix", M);
  print("gravity and velocity terms", torque - f);
  print("udot", udot);
}
