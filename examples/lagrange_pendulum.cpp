// A pendulum described by the coordinates of its bob, by Lagrange's method: the equations, and the tension of
// its string.
#include "print.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/symbolic.hpp>
#include <models/pendulum_nonminimal.hpp>

#include <iostream>

int main() {
  using namespace pendulum_nonminimal;
  using eom = kanexpr::equations_of_motion<LagrangeSystem>;

  auto model = kanexpr::derive<LagrangeSystem>();
  std::cout << "M of q2'': " << kanexpr::symbolic::print(model.mass_matrix()(0, 0))
            << "\nf:        " << kanexpr::symbolic::print(model.forcing()(0, 0))
            << "\nlambda:   " << kanexpr::symbolic::print(model.multipliers()(0, 0)) << "\n\n";

  eom::parameters p;
  p[m] = 1.3;
  p[L] = 0.7;
  p[g] = 9.81;

  for (const double aside : {-0.45, 0.0, 0.3}) {
    eom::state x;
    x[q2] = aside;
    x[q1] = 0.6; // approximate; `assemble` makes the string taut
    x[dot(q2)] = 1.2;
    if (!kanexpr::assemble<LagrangeSystem>(x, p)) return 1;
    std::printf("the bob is at (%.4f, %.4f) and moves with (%.4f, %.4f)\n", x[q1], x[q2], x[dot(q1)],
                x[dot(q2)]);
    // The multiplier of q1^2 + q2^2 == L^2 acts along (2 q1, 2 q2).
    print("pull of the string", -2 * p[L] * eom::multipliers(x, p)(0));
  }
}
