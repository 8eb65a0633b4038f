// expect: speed v, which a Jacobian contains, is not in the list of speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, jacobian(velocity_of<P>, u, v)> columns;
  const Eigen::Matrix<double, 3, 2> value = columns(eom::state(), eom::parameters());
  return value(0) > 0;
}
