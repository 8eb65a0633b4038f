// expect: the offset of point End contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct End : offset<End, P, u * A::x> {}; // which the system does not use

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, velocity_of<End>> velocity;
  const Eigen::Vector3d value = velocity(eom::state(), eom::parameters());
  return value(0) > 0;
}
