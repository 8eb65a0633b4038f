// The KUKA iiwa 14 with numeric values; the reference is RBDL.
#include "print.hpp"

#include <models/iiwa.hpp>

int main() {
  using namespace iiwa;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q<1>] = 1.5983500054156474;
  x[q<2>] = 2.8230427165131764;
  x[q<3>] = -2.403856968140654;
  x[q<4>] = 2.462463113609908;
  x[q<5>] = -2.253957243345467;
  x[q<6>] = -2.795432129551702;
  x[q<7>] = 2.089303505574744;
  x[u<1>] = 1.6028419058388335;
  x[u<2>] = 1.0229801389603872;
  x[u<3>] = -0.7658851334901042;
  x[u<4>] = 1.9810473071146575;
  x[u<5>] = -0.9295545463277721;
  x[u<6>] = -1.827115098690923;
  x[u<7>] = -1.3251036898270434;
  eom::inputs torque;
  torque[T<1>] = 4.3581136929800675;
  torque[T<2>] = -2.0510909116853213;
  torque[T<3>] = -3.9198967114836556;
  torque[T<4>] = 7.330850218702025;
  torque[T<5>] = -4.1536102078199875;
  torque[T<6>] = -7.5263821324586715;
  torque[T<7>] = -3.3813444387841574;

  // All results in one call, because they share subexpressions.
  const eom::parameters none; // the numbers are part of the type
  const auto [M, f, udot] = eom::together(eom::mass_matrix, eom::forcing, eom::udot)(x, none, torque);

  print("mass matrix", M);
  print("gravity and velocity terms", torque - f);
  print("udot", udot);
}
