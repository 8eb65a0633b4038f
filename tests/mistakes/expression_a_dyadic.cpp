// expect: what a function is asked for is a dyadic; it must be a scalar or a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, outer(A::x, A::y)> dyadic;
  return dyadic(eom::state(), eom::parameters()) > 0;
}
