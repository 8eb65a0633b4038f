// expect: the state vector of System has 2 entries, not 3
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  const Eigen::Vector3d x(1, 2, 3);
  const double M = eom::mass_matrix(x, eom::parameters());
  return M > 0;
}
