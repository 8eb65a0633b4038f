// expect: the parameter vector of System has 3 entries, not 1
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  const double M = eom::mass_matrix(eom::state(), Eigen::Matrix<double, 1, 1>(2.0));
  return M > 0;
}
