// expect: the direction cosines of frame B are not orthonormal; write irrational entries as sqrt or cos of
// expect: numbers
#include "pendulum.hpp"

struct B : direction_cosines<B, A, 0.6, 0.8, 0, 0.8, 0.6, 0, 0, 0, 1> {}; // which the system does not use

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, dot(angular_velocity_of<B>, N::z)> rate;
  const double value = rate(eom::state());
  return value > 0;
}
