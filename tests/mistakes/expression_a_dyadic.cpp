// expect: a function requests a dyadic; it must request a scalar or a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, outer(A::x, A::y)> dyadic;
  return dyadic(eom::state(), eom::parameters()) > 0;
}
