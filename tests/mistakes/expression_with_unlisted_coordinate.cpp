// expect: coordinate s, which an expression contains, is not in the list of coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, s * sin(q)> product;
  const double value = product(eom::state());
  return value > 0;
}
