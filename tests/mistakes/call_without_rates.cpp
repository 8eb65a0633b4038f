// expect: inertia_forces needs the rate of speed u: call it as inertia_forces(x, p, r, a)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  const double f = eom::inertia_forces(eom::state(), eom::parameters(), eom::inputs());
  return f > 0;
}
