#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;
using to_second = second_order<System>;

int main() {
  const eom::state x;
  const eom::parameters p;
  const eom::inputs r;
  const to_second::weights<> w(1, 1);
  double sum = 0;
  // expect: hessian needs a weight for each rate of the state: call it as hessian(x, p, r, w)
  sum += to_second::hessian(x, p, r)(0);
  // expect: hessian_product needs a direction (a change in the state and the inputs): call it as
  // expect: hessian_product(x, p, r, w, v)
  sum += to_second::hessian_product(x, p, r, w)(0);
  // expect: a sensitivity is requested with respect to q; it must be a parameter
  sum += sensitivity<System, q>(x, p, r)(0);
  return sum > 0;
}
