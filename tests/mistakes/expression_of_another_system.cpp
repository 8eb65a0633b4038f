// expect: frame M, which Z uses, is not connected to the inertial frame N
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;
struct M : inertial_frame<M> {};
struct Z : origin<Z, M> {};

int main() {
  kanexpr::function<System, position_of<P, Z>> distance;
  const Eigen::Vector3d value = distance(eom::state(), eom::parameters());
  return value(0) > 0;
}
