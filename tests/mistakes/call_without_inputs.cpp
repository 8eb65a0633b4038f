// expect: forcing needs the input T: call it as forcing(x, p, r)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  const Eigen::Matrix<double, 1, 1> f(eom::forcing(eom::state(), eom::parameters()));
  return f(0) > 0;
}
