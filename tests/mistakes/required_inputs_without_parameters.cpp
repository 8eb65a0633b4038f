// expect: required_inputs needs the parameter m: call it as required_inputs(x, p, r, a)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() { eom::required_inputs(eom::state(), {}, {}, Eigen::Matrix<double, 1, 1>(1.0)); }
