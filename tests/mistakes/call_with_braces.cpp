// expect: mass_matrix needs the parameter m: call it as mass_matrix(x, p)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  const double M = eom::mass_matrix(eom::state(), {}, {});
  return M > 0;
}
