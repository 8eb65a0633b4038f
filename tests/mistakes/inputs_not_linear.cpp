// expect: required inputs are defined only for forces linear in the inputs; they are not linear in T
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, inputs<T>,
                            bodies<Bob>, loads<torque<A, T * T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  eom::required_inputs(eom::state(), eom::parameters(), eom::inputs(), Eigen::Matrix<double, 1, 1>(1.0));
}
