// expect: an expression adds a scalar and a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, u + N::x> sum;
  const Eigen::Vector3d value = sum(eom::state());
  return value(0) > 0;
}
