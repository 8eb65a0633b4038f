// expect: rhs needs the parameter m: call it as rhs(x, p)
#include "pendulum.hpp"

#include <kanexpr/fixed_step.hpp>

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

int main() {
  double now = 0;
  state<System> x;
  return runge_kutta_4<System>{}(now, x, 0.01) ? 0 : 1;
}
