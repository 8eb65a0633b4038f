// expect: the position of P from Bearing is not known: they are measured from two origins, O and Bearing
#include "pendulum.hpp"

struct Bearing : origin<Bearing, N> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, position_of<P, Bearing>> position;
  const Eigen::Vector3d value = position(eom::state(), eom::parameters());
  return value(0) > 0;
}
